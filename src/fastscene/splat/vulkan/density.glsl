// Density control with a fixed number of splats (splat/relocate.h): splats are sampled by their error and split in two;
// the second halves are appended (growth) or take the place of dead splats (relocation).
layout(local_size_x = 256) in;

const float kDeadOpacity = 0.005, kHalfOffset = 0.6, kHalfSize = 0.75, kHalfDensity = 0.72;
const uint kGroupSplats = 256;  // summed by one workgroup

bool grows() { return first == 0; }
float growth() { return plan.rates[0]; }  // share of the splats that are added
uint groups() { return (t.counters.count + kGroupSplats - 1) / kGroupSplats; }

float value(int p, uint i) { return t.parameters.at[uint(p) * t.capacity + i]; }
float opacity_of(uint i) { return 1.0 / (1.0 + exp(-value(10, i))); }
bool is_dead(uint i) {
    float sum = 0.0;
    for (int p = 0; p < kParameters; ++p) sum += abs(value(p, i));
    return !(sum < 1e9) || !(opacity_of(i) >= kDeadOpacity);
}
// Probability of being split, up to a factor.
float error_of(uint i) {
    const float error = t.seen_error.at[i];
    return error > 0.0 && (grows() || !is_dead(i)) ? error : 0.0;
}
// How many splats to sample.
uint wanted() {
    return grows() ? min(uint(growth() * float(t.counters.count)), t.most_splats - t.counters.count) : t.density.dead;
}
