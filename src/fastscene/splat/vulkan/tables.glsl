// What all kernels share: the buffers of a training run (tables.h is the host's side), the settings of one step, and
// sizes. Splat parameters are stored as planes of `capacity` floats, one a parameter: neighbouring invocations read
// neighbouring floats.
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_control_flow_attributes : enable
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_vote : require
#extension GL_KHR_shader_subgroup_ballot : require
#extension GL_KHR_shader_subgroup_shuffle : require
#extension GL_KHR_shader_subgroup_arithmetic : require

layout(constant_id = 0) const uint kSubgroup = 32;  // invocations in a subgroup: 8, 16, 32 or 64

// As in splat/project.h, blend.h and kernel.h.
const float kNearM = 0.1, kLeastArea2 = 1e-12;
const float kMinAlpha = 1.0 / 255.0, kMaxAlpha = 0.99, kOpaque = 1.0 / 255.0, kOutsideVisible = 0.5;
const float kLog2E = 1.4426950408889634, kLog2Of255 = 7.9943534368588579, kSh0 = 0.28209479177387814;
const float kAdamEpsilon = 1e-7, kBeta1 = 0.9, kBeta2 = 0.999;
const int kParameters = 14;
const uint kTile = 16;       // side of a tile, pixels
const uint kSlotFloats = 12;  // 6 moments, 3 colors, blending weight, weight * error, depth
const uint kNoKey = 0xffffffffu;

layout(buffer_reference, std430, buffer_reference_align = 16) buffer Floats { float at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Words { uint at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Vec2s { vec2 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Vec4s { vec4 at[]; };
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Boxes { uvec2 at[]; };

// Counted on the device, read there only.
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Counters {
    uint count;    // splats
    uint visible;  // records of this step
    uint pairs;    // of a record and a tile it may touch
    uint failed;   // the first step whose pairs did not fit, or 0: from there on nothing changes
};
// What the host learns of a step.
struct Outcome {
    float loss, squared_error;
    uint visible, pairs, failed;
};
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Outcomes { Outcome at[]; };

// What density control counts.
layout(buffer_reference, std430, buffer_reference_align = 16) buffer Density {
    float error;  // of all splats
    uint dead, taken;
};

const uint kEquirect = 1, kAntialias = 2, kJudge = 4, kDepth = 8, kOpen = 16, kMoves = 32, kGradientsOnly = 64,
           kNoLoss = 128, kRenderOnly = 256;

layout(buffer_reference, std430, buffer_reference_align = 16) readonly buffer Plan {
    vec4 row_x, row_y, row_z;  // camera_from_world: a row of the rotation, and the translation's component
    vec4 lens;                 // fx, fy, cx, cy
    vec4 slopes;               // min_u, max_u, min_v, max_v
    vec4 center;               // the camera in the world; w: depth from which splats belong to the outside
    vec4 background;           // w: lambda of D-SSIM
    float rates[16];           // Adam's, of the 14 parameters, bias-corrected; [14]: of SH degrees >= 1
    vec4 middle;               // beyond 1 / w metres from here, position steps grow with the distance
    vec4 adam;                 // 1 / sqrt(bias 2), the same for SH degrees >= 1, strengths of the regularizers
    vec4 weights;              // of the depth loss and of transmittance, a pixel; half the picture's size in pixels;
                               // w: low-pass in square pixels
    uvec4 size;                // width, height, tiles across, tiles down
    // number: of the step, from 1; outcome: its place in the list. For density control: rates[0] is the growth, degree
    // a seed, and flags the SH degree << 16.
    uint flags, degree, number, outcome;
    Words target;              // RGB and weight, one byte each
    Floats depth;              // the target's, metres; 0: unknown
};

layout(buffer_reference, std430, buffer_reference_align = 16) buffer Tables {
    Floats parameters, first_moment, second_moment;
    Floats rest, rest_first_moment, rest_second_moment;
    Floats seen_weight, seen_error, seen_move, seen_steps;
    Floats gradients, rest_gradients;
    Vec4s records;     // three a record, see load_record()
    Boxes boxes;       // tile x | y << 16, tiles wide | high << 16; zero: not visible
    Words first_pair;  // of each record, in depth order
    Words depth_keys[2], depth_records[2];
    Words pair_tiles[2], pair_records[2];
    Words histogram, block_pairs;
    Words tile_begin, stops;
    Vec4s color;  // of each pixel, and the transmittance
    Floats depth;
    Floats maps;  // dSSIM / d(blurred x, x^2 + y^2, x y) of each channel
    Vec4s v;      // dL/d color, and the error
    Vec2s v_more; // dL/d(depth sum), dL/d transmittance
    Vec4s slots;        // three a pair
    Floats slot_floats;  // the same
    Floats dssim;    // sum of each tile and channel
    Vec4s sums;      // of each tile: L1, squared error, depth, transmittance
    Counters counters;
    Outcomes outcomes;
    Density density;
    Floats density_errors;  // of each group of splats; then of all groups before
    Words density_dead;     // likewise
    Words density_claims;   // of each splat: the first sample that chose it
    Words density_choices, density_ranks, density_free;
    uint capacity;       // floats of a plane
    uint most_splats;
    uint pair_capacity;
};

layout(push_constant) uniform Push {
    Tables t;
    Plan plan;
    uint shift, bits;  // of a radix pass
    uint side;         // which of the two lists it reads; of the result for later kernels
    uint first;        // 1: the first pass by depth, which drops what is not visible
};

// Members are read whole: some drivers get single components of vectors behind pointers wrong (Mesa 22's lavapipe).
vec4 plan_row_x() { return plan.row_x; }
vec4 plan_row_y() { return plan.row_y; }
vec4 plan_row_z() { return plan.row_z; }
vec4 plan_lens() { return plan.lens; }
vec4 plan_slopes() { return plan.slopes; }
vec4 plan_center() { return plan.center; }
vec4 plan_background() { return plan.background; }
vec4 plan_middle() { return plan.middle; }
vec4 plan_adam() { return plan.adam; }
vec4 plan_weights() { return plan.weights; }
uvec4 plan_size() { return plan.size; }
float rate_of(int p) { return plan.rates[p]; }

bool flag(uint f) { return (plan.flags & f) != 0; }
bool has_failed() { return t.counters.failed != 0; }
