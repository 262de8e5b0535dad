# Models of others: listed, pulled from a mirror, verified, found by those who need them.
. "$(dirname "$0")/lib.sh"

expect 0 "$fastscene" models list
for name in diffusion360 da2 egformer aotgan-places2 lpips clip-vit-large-patch14; do prints "$name"; done
prints "licence: "
expect 0 "$fastscene" models list --json
prints '"sha256"'
prints "https://download.pytorch.org/models/vgg19-dcbb9e9d.pth"
expect 0 "$fastscene" models list
prints "egformer/EGformer_pretrained.pkl"
prints "diffusion360/sd-base/unet/diffusion_pytorch_model.safetensors or diffusion360/sd-base/unet/diffusion_pytorch_model.bin"
expect 0 "$fastscene" models path egformer
prints "$FASTSCENE_MODELS/egformer"
expect 2 "$fastscene" models
expect 2 "$fastscene" models pull
expect 2 "$fastscene" models pull da2
says "licence: unclear"
says "CC BY-NC"
expect 2 "$fastscene" models pull egformr
says "egformer"

# Nothing here is said, not passed over.
FASTSCENE_MODELS=$work/none expect 0 "$fastscene" models verify
prints "no file of any model is here, in $work/none"

# Fetched by hand, or from a mirror.
expect 1 "$fastscene" models pull egformer --accept
says "by hand"
mkdir -p mirror/egformer && head -c 200000 /dev/urandom >mirror/egformer/EGformer_pretrained.pkl
expect 1 "$fastscene" models pull egformer --mirror mirrror --accept
says "mirror mirrror: expected a folder"
expect 2 "$fastscene" models pull egformer --mirror mirror
says "licence: MIT"
says "--accept"
lacks "$FASTSCENE_MODELS/egformer/EGformer_pretrained.pkl"
FASTSCENE_MODELS_MIRROR=file://$work/mirror expect 0 "$fastscene" models pull egformer --accept
prints "fetched"
cmp mirror/egformer/EGformer_pretrained.pkl "$FASTSCENE_MODELS/egformer/EGformer_pretrained.pkl" || fail "other bytes than the mirror's"
expect 0 "$fastscene" models pull egformer
prints "here"
no_rest "$FASTSCENE_MODELS"
expect 0 "$fastscene" models verify
prints "hash not known beforehand"
printf x >>"$FASTSCENE_MODELS/egformer/EGformer_pretrained.pkl"
expect 1 "$fastscene" models verify egformer
prints "damaged"
says "models pull egformer --mirror"
expect 0 "$fastscene" models list
prints "here, 201 kB"
expect 0 "$fastscene" models pull egformer --mirror mirror
prints "fetched"
expect 0 "$fastscene" models verify egformer

# A hash that is known is insisted on.
mkdir -p mirror/niqe && head -c 8347 /dev/zero >mirror/niqe/modelparameters.mat
expect 1 "$fastscene" models pull niqe --accept --mirror mirror
says "expected SHA-256 fa2aa4d1"
lacks "$FASTSCENE_MODELS/niqe/modelparameters.mat"
no_rest "$FASTSCENE_MODELS"

# Those who need a model look for it, name its file, and say what helps.
convert_ok() { "$fastscene" panorama "$prompt" -o p "${tiny[@]:0:10}" >/dev/null 2>&1; }
convert_ok || fail "no panorama"
expect 1 "$fastscene" make --panorama p/panorama/color.png --depth-backend egformer -o q "${tiny[@]}"
says "EGformer_pretrained.pkl"
rm -rf "$FASTSCENE_MODELS/egformer"
expect 2 "$fastscene" make "$prompt" --panorama diffusion360 -o q "${tiny[@]}"
says "models pull diffusion360"
expect 2 "$fastscene" make "$prompt" --photo p/panorama/color.png -o q "${tiny[@]}"
says "--panorama diffusion360"
lacks q
expect 0 "$fastscene" doctor
prints "to paint"
prints "models"
