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
    v("steps", p.steps, Bounds{1, 2e9}, "Total number of steps; a larger number continues a finished training.");
    v("minutes", p.minutes, Bounds{0, 1e7},
      "Stop after N minutes of this call, with a checkpoint; 0 = only after --steps.");
    v("batch", p.batch, Bounds{1, 4096}, "Batch size.");
    v("learning-rate", p.learning_rate, Bounds{0, 1}, "Adam's learning rate after the warm-up.");
    v("final-learning-rate", p.final_learning_rate, Bounds{0, 1}, "Learning rate at --steps; cosine decay in between.");
    v("warmup", p.warmup, Bounds{0, 1e6}, "Warm-up steps in which the learning rate grows from 0.");
    v("ema-decay", p.ema_decay, Bounds{0, 0.999999},
      "Decay per step of the exponential moving average of the weights, which is the network that is saved.");
    v("clip", p.clip, Bounds{0, 1e9}, "Gradient clipping: maximum norm of a network's gradient; 0 = none.");
    v("log-steps", p.log_steps, Bounds{1, 1e6}, "Steps between rows of curves.csv.");
    v("eval-steps", p.eval_steps, Bounds{1, 1e9},
      "Steps between evaluations on the held-out pictures: metrics, and a contact sheet.");
    v("checkpoint-minutes", p.checkpoint_minutes, Bounds{0, 1e5}, "Minutes between checkpoints.");
    v("device", p.device, Choices{{"auto", "cpu", "cuda"}}, "Device; auto: CUDA if libtorch supports it.");
    v("precision", p.precision, Choices{{"auto", "f32", "bf16"}},
      "Precision of convolutions and matrix products; auto: bf16 if the device supports it.");
    v("processes", p.processes, Bounds{1, 4096},
      "World size: data-parallel processes, on one or several machines. Each draws its own --batch pictures per step, "
      "and gradients are averaged. Processes that srun starts need none of these three flags.");
    v("process", p.process, Bounds{0, 4095}, "Rank of this process, from 0; rank 0 writes the folder.");
    v("meet", p.meet, "Rendezvous endpoint: HOST:PORT at which rank 0 waits for the others.");
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
