#include "fastscene/models/registry.h"

#include <algorithm>

#include <fmt/ranges.h>

#include "fastscene/base/error.h"

namespace fastscene {
namespace {

// The commit that has everything except the photo network.
const std::string kPanoramas =
    "https://huggingface.co/archerfmy0831/sd-t2i-360panoimage/resolve/af3c6eb2964edfc5826bf2604071f21e370b06bc/";
const std::string kPanoramasHome = "https://huggingface.co/archerfmy0831/sd-t2i-360panoimage";
const std::string kOpenRail =
    "Apache-2.0 according to its page; derived from Stable Diffusion, whose CreativeML OpenRAIL-M restricts its use";
const std::string kOpenRailUrl = "https://huggingface.co/spaces/CompVis/stable-diffusion-license";
const std::string kTorchvision = "https://download.pytorch.org/models/";
const std::string kLive =
    "Laboratory for Image and Video Engineering, University of Texas at Austin: free use with its notice";

// Files of a model in diffusers' layout, without unused ones: safety checker, feature extractor.
std::vector<ModelFile> diffusers_files(const std::string& part, std::vector<ModelFile> weights) {
    std::vector<ModelFile> all = std::move(weights);
    for (const char* name :
         {"unet/config.json", "vae/config.json", "text_encoder/config.json", "scheduler/scheduler_config.json",
          "tokenizer/merges.txt", "tokenizer/special_tokens_map.json", "tokenizer/tokenizer_config.json"})
        all.push_back({part + "/" + name, 0, ""});
    return all;
}

std::vector<ModelFile> base_files() {
    return diffusers_files(
        "sd-base",
        {{"sd-base/unet/diffusion_pytorch_model.safetensors|sd-base/unet/diffusion_pytorch_model.bin", 0, ""},
         {"sd-base/vae/diffusion_pytorch_model.safetensors|sd-base/vae/diffusion_pytorch_model.bin", 0, ""},
         {"sd-base/text_encoder/model.safetensors|sd-base/text_encoder/pytorch_model.bin", 0, ""}});
}

// Shared by upscaling and by outpainting of photos.
std::vector<ModelFile> painter_files() {
    return diffusers_files("sr-base",
                           {{"sr-base/unet/diffusion_pytorch_model.bin", 0,
                             "f29a6a554f406a6121afdb40b2f0b4d0ebabbec4291e96a7615e420d36eda47d"},
                            {"sr-base/vae/diffusion_pytorch_model.bin", 0,
                             "36bb8e1b54aba3a0914eb35fba13dcb107e9f18d379d1df2158732cd4bf56a94"},
                            {"sr-base/text_encoder/model.safetensors|sr-base/text_encoder/pytorch_model.bin", 0, ""}});
}

std::vector<ModelFile> with(std::vector<ModelFile> files, const std::vector<ModelFile>& more) {
    files.insert(files.end(), more.begin(), more.end());
    return files;
}

std::vector<Model> panorama_models() {
    return {
        {"diffusion360", "diffusion360", "Diffusion360: generates the first panorama from the prompt, 1024 x 512.",
         "make --panorama diffusion360", kOpenRail, kOpenRailUrl, kPanoramasHome, kPanoramas, base_files()},
        {"diffusion360-upscale", "diffusion360",
         "Diffusion360's upscaling: ControlNet tile and Real-ESRGAN, to 6144 x 3072.",
         "make --panorama diffusion360 --panorama-upscale", kOpenRail + "; Real-ESRGAN BSD-3-Clause", kOpenRailUrl,
         kPanoramasHome, kPanoramas,
         with(painter_files(),
              {{"sr-control/config.json", 0, ""},
               {"sr-control/diffusion_pytorch_model.safetensors|sr-control/diffusion_pytorch_model.bin", 0, ""},
               {"RealESRGAN_x2plus.pth", 67061725,
                "49fafd45f8fd7aa8d31ab2a22d14d91b536c34494a5cfe31eb5d89c2fa266abb"}})},
        {"diffusion360-photo", "diffusion360", "Diffusion360 from one photo: the ControlNet that outpaints it.",
         "make --panorama diffusion360 --photo FILE", kOpenRail, kOpenRailUrl, kPanoramasHome, kPanoramas,
         with(painter_files(), {{"sd-i2p/config.json", 0, "", kPanoramasHome + "/resolve/main/sd-i2p/config.json"},
                                {"sd-i2p/diffusion_pytorch_model.bin", 0,
                                 "46a6400a21392229f09c94eed18f46c46c1a134a2abcacd10fcfa3916fa99044",
                                 kPanoramasHome + "/resolve/main/sd-i2p/diffusion_pytorch_model.bin"}})},
    };
}

std::vector<Model> scene_models() {
    return {
        {"da2",
         "da2",
         "DA-2 (Depth Anything in Any Direction): the most accurate depth estimation for panoramas.",
         "make --depth-backend da2",
         "unclear: of the weights, records of their page tell Apache-2.0 and terms of use of their own: read it. The "
         "code is Apache-2.0; a part of it is modelled on UniK3D's, which is CC BY-NC",
         "https://huggingface.co/haodongli/DA-2",
         "https://huggingface.co/haodongli/DA-2",
         "https://huggingface.co/haodongli/DA-2/resolve/0d55ccb5e46b8ed4715fae3a4c04fc897f1689f3/",
         {{"model.safetensors", 1378513064, "d8ea568fc3dfb7d7432e5b763de499dd03fb6dc1c2020d84639f35e2dfa4f78e"}}},
        {"egformer",
         "egformer",
         "EGformer: depth estimation for photographed and generated panoramas.",
         "make --depth-backend egformer",
         "MIT (its code; no separate licence for the weights)",
         "https://github.com/yuniw18/EGformer",
         "https://drive.google.com/drive/folders/15L5RviWqd63TS1L3gwxqggiEgkZS5Yjg",
         "",
         {{"EGformer_pretrained.pkl", 0, ""}}},
        {"aotgan-places2",
         "aotgan-places2",
         "AOT-GAN trained on Places2: inpaints the holes of the walk. G0000000.pt of its download.",
         "make --walk-inpainter aotgan",
         "Apache-2.0 (its code; no separate licence for the weights)",
         "https://github.com/researchmm/AOT-GAN-for-Inpainting/blob/master/LICENSE",
         "https://drive.google.com/drive/folders/1bSOH-2nB3feFRyDEmiX81CEiWkghss3i",
         "",
         {{"G0000000.pt", 0, ""}}},
        {"vgg19",
         "vgg19",
         "VGG19 of torchvision: AOT-GAN's losses, for training.",
         "its path",
         "BSD-3-Clause (torchvision)",
         "https://github.com/pytorch/vision/blob/main/LICENSE",
         "https://github.com/pytorch/vision",
         kTorchvision,
         {{"vgg19-dcbb9e9d.pth", 574673361, "dcbb9e9dad569fff7a846263a77324fc34978fea2bfb039c012d710e1776ae44"}}},
    };
}

std::vector<Model> metric_models() {
    const std::string lpips =
        "https://raw.githubusercontent.com/richzhang/PerceptualSimilarity/082bb24f84c091ea94de2867d34c4544f68e0963/"
        "lpips/weights/v0.1/";
    const std::string quality = "https://raw.githubusercontent.com/opencv/opencv_contrib/4.x/modules/quality/samples/";
    return {
        {"lpips",
         "lpips",
         "LPIPS v0.1 with AlexNet and VGG16.",
         "metrics images --reference",
         "BSD-2-Clause (LPIPS), BSD-3-Clause (torchvision)",
         "https://github.com/richzhang/PerceptualSimilarity/blob/master/LICENSE",
         "https://github.com/richzhang/PerceptualSimilarity",
         kTorchvision,
         {{"alexnet-owt-7be5be79.pth", 0, "7be5be791159472b1fbf3c69796f7cb30dca7ad8466c2df70058c37116cdee02"},
          {"vgg16-397923af.pth", 0, "397923af8e79cdbb6a7127f12361acd7a2f83e06b05044ddf496e83de57a5bf0"},
          {"lpips/alex.pth", 6009, "df73285e35b22355a2df87cdb6b70b343713b667eddbda73e1977e0c860835c0",
           lpips + "alex.pth"},
          {"lpips/vgg.pth", 7289, "a78928a0af1e5f0fcb1f3b9e8f8c3a2a5a3de244d830ad5c1feddc79b8432868",
           lpips + "vgg.pth"}}},
        {"niqe",
         "niqe",
         "NIQE's model of pristine pictures.",
         "metrics images",
         kLive,
         "https://github.com/utlive/niqe/blob/main/readme.txt",
         "https://github.com/utlive/niqe",
         "https://raw.githubusercontent.com/utlive/niqe/d80aead297ff48b0254c39806f3a277b3ecbfc8d/",
         {{"modelparameters.mat", 8347, "fa2aa4d12dd9595c3fb6bf8b4e1a15c79d5d1469238d0901c88dead195be578d"}}},
        {"brisque",
         "brisque",
         "BRISQUE's regression by its authors.",
         "metrics images",
         kLive,
         "https://github.com/utlive/BRISQUE/blob/main/MATLAB/readme.txt",
         "https://github.com/utlive/BRISQUE",
         "https://raw.githubusercontent.com/utlive/BRISQUE/2e2a5ac04cd4b73ac0f5867de5b974581fa2d4d2/MATLAB/",
         {{"allmodel", 353497, "8b04d6045f1b27261610c8ab1730fdcc14ec80bfab0f1ab5f703bbc2927314de"},
          {"allrange", 741, "e47d753d96b631e1aa2dbac8c4e51ade767f2def8ce678c7130b6b3f90ee915f"}}},
        {"brisque-opencv",
         "brisque-opencv",
         "BRISQUE's regression as retrained by OpenCV.",
         "metrics images",
         "Apache-2.0 (OpenCV)",
         "https://github.com/opencv/opencv_contrib/blob/4.x/LICENSE",
         "https://github.com/opencv/opencv_contrib/tree/4.x/modules/quality",
         quality,
         {{"brisque_model_live.yml", 567815, "4c44c7eec9e5139830c0bb0e4a044c9cd351ba5bbc9e3798beca3243e2782ff4"},
          {"brisque_range_live.yml", 1356, "a18427f4f7ad087524bd0d63389649a3899b51ca6d44a4d5f8d8171f1f914a9c"}}},
        {"clip-vit-base-patch32",
         "clip-vit-base-patch32",
         "CLIP ViT-B/32: agreement of a picture with a text.",
         "metrics images --prompt",
         "MIT (OpenAI)",
         "https://github.com/openai/CLIP/blob/main/LICENSE",
         "https://huggingface.co/openai/clip-vit-base-patch32",
         "https://huggingface.co/openai/clip-vit-base-patch32/resolve/3d74acf9a28c67741b2f4f2ea7635f0aaf6f0268/",
         {{"pytorch_model.bin", 0, "a63082132ba4f97a80bea76823f544493bffa8082296d62d71581a4feff1576f"},
          {"config.json", 0, ""},
          {"merges.txt", 0, ""}}},
        {"clip-vit-large-patch14",
         "clip-vit-large-patch14",
         "CLIP ViT-L/14, a larger network.",
         "metrics images --prompt",
         "MIT (OpenAI)",
         "https://github.com/openai/CLIP/blob/main/LICENSE",
         "https://huggingface.co/openai/clip-vit-large-patch14",
         "https://huggingface.co/openai/clip-vit-large-patch14/resolve/main/",
         {{"model.safetensors", 1710540580, "a2bf730a0c7debf160f7a6b50b3aaf3703e7e88ac73de7a314903141db026dcb"},
          {"config.json", 0, ""},
          {"merges.txt", 0, ""}}},
    };
}

}  // namespace

std::vector<std::string> ModelFile::names() const {
    std::vector<std::string> out;
    for (std::size_t at = 0; at <= name.size();) {
        const std::size_t end = std::min(name.find('|', at), name.size());
        out.push_back(name.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

std::int64_t Model::known_bytes() const {
    std::int64_t sum = 0;
    for (const ModelFile& file : files) sum += file.bytes;
    return sum;
}

std::vector<std::string> urls_of(const Model& model, const ModelFile& file) {
    if (!file.url.empty()) return {file.url};
    std::vector<std::string> out;
    if (!model.by_hand())
        for (const std::string& name : file.names()) out.push_back(model.base + name);
    return out;
}

const std::vector<Model>& models() {
    static const std::vector<Model> all = [] {
        std::vector<Model> out = panorama_models();
        for (const auto& more : {scene_models(), metric_models()}) out.insert(out.end(), more.begin(), more.end());
        return out;
    }();
    return all;
}

const Model& model_named(std::string_view name) {
    std::vector<std::string> names;
    for (const Model& model : models()) {
        if (model.name == name) return model;
        names.push_back(model.name);
    }
    throw UsageError("models: expected one of {}, found \"{}\"", fmt::join(names, ", "), name);
}

}  // namespace fastscene
