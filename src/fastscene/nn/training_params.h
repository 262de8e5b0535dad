// Training settings shared by `inpaint train` and `depth train`. Free of libtorch.
#pragma once

#include <string>

#include "fastscene/base/fields.h"

namespace fastscene {

struct TrainingParams {
    int steps = 100000;
    double minutes = 0;
    int batch = 4;
    double learning_rate = 1e-4, final_learning_rate = 1e-4;
    int warmup = 100;
    double ema_decay = 0.999;
    double clip = 1;
    int log_steps = 50, eval_steps = 1000;
    double checkpoint_minutes = 5;
    std::string device = "auto", precision = "auto";
    int processes = 1, process = 0;
    std::string meet = "";
};
template <class V>
void visit_fields(TrainingParams& p, V&& v) {
    v("steps", p.steps, Bounds{1, 2e9}, "Steps in all; a larger number goes on with a finished training.");
    v("minutes", p.minutes, Bounds{0, 1e7},
      "Stop after so many minutes of this call, with a checkpoint; 0 = only after --steps.");
    v("batch", p.batch, Bounds{1, 4096}, "Pictures a step.");
    v("learning-rate", p.learning_rate, Bounds{0, 1}, "Adam's rate after the warm-up.");
    v("final-learning-rate", p.final_learning_rate, Bounds{0, 1}, "Its rate at --steps; in between half a cosine.");
    v("warmup", p.warmup, Bounds{0, 1e6}, "Steps in which the rate grows from 0.");
    v("ema-decay", p.ema_decay, Bounds{0, 0.999999},
      "The network that is kept is a running average of the trained one; this is what stays of it each step.");
    v("clip", p.clip, Bounds{0, 1e9},
      "Longest gradient of a network; longer ones are shortened to it. 0 = any length.");
    v("log-steps", p.log_steps, Bounds{1, 1e6}, "Steps between rows of curves.csv.");
    v("eval-steps", p.eval_steps, Bounds{1, 1e9},
      "Steps between looks at the held-out pictures: their figures, and a sheet.");
    v("checkpoint-minutes", p.checkpoint_minutes, Bounds{0, 1e5}, "Minutes between checkpoints.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}}, "Where it is trained; auto: CUDA if libtorch has it.");
    v("precision", p.precision, Choices{{"auto", "f32", "bf16"}},
      "Of convolutions and products; auto: bf16 where the device computes with it.");
    v("processes", p.processes, Bounds{1, 4096},
      "Processes that train together, on one machine or many: each with --batch pictures a step of its own, and the "
      "mean of all gradients.");
    v("process", p.process, Bounds{0, 4095}, "Which of them this is; 0 keeps the folder.");
    v("meet", p.meet, "HOST:PORT at which process 0 awaits the others.");
}

// The settings that must not change when a training is resumed; all others may.
inline Json lasting_settings(const TrainingParams& params) {
    Json all = fields_json(params);
    for (const char* free :
         {"steps", "minutes", "log-steps", "eval-steps", "checkpoint-minutes", "device", "process", "meet"})
        all.erase(free);
    return all;
}

}  // namespace fastscene
