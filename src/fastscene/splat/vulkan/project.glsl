// Projection of a Gaussian (splat/project.h) and its gradient (splat/project_grad.h): the same formulas and names.

struct Gaussian {
    vec3 mean, log_scale;
    vec4 rotation;  // w, x, y, z
    float logit;
    vec3 sh0;
};
struct Rows {
    vec3 a, b, c;
};
struct Projection {
    vec3 p;  // in the camera
    float inv_z, u, v, u_held, v_held;
    vec3 slope_x, slope_y;
    float inv_h2, inv_r2, h;
    float depth;
    vec2 at;
    Rows turn;  // camera_from_local
    vec3 scale, n0, n1, m0, m1;
    float xx, xy, yy;
    vec3 conic;
    vec3 area;
    float opacity, log2_opacity;
    vec3 color_raw;
};

Rows matrix_of(vec4 q) {
    const float s = 2.0 / dot(q, q);
    const float w = q.x, x = q.y, y = q.z, z = q.w;
    return Rows(vec3(1.0 - (y * y + z * z) * s, (x * y - w * z) * s, (x * z + w * y) * s),
                vec3((x * y + w * z) * s, 1.0 - (x * x + z * z) * s, (y * z - w * x) * s),
                vec3((x * z - w * y) * s, (y * z + w * x) * s, 1.0 - (x * x + y * y) * s));
}
// a * b, by rows.
Rows times(Rows a, Rows b) {
    return Rows(a.a.x * b.a + a.a.y * b.b + a.a.z * b.c, a.b.x * b.a + a.b.y * b.b + a.b.z * b.c,
                a.c.x * b.a + a.c.y * b.b + a.c.z * b.c);
}
vec3 times(Rows a, vec3 x) { return vec3(dot(a.a, x), dot(a.b, x), dot(a.c, x)); }
vec3 times_transposed(Rows a, vec3 x) { return a.a * x.x + a.b * x.y + a.c * x.z; }
Rows times_transposed(Rows a, Rows b) {
    return Rows(a.a.x * b.a + a.b.x * b.b + a.c.x * b.c, a.a.y * b.a + a.b.y * b.b + a.c.y * b.c,
                a.a.z * b.a + a.b.z * b.b + a.c.z * b.c);
}
Rows camera_rows() { return Rows(plan.row_x.xyz, plan.row_y.xyz, plan.row_z.xyz); }

float parameter(int p, uint i) { return t.parameters.at[uint(p) * t.capacity + i]; }
Gaussian load_gaussian(uint i) {
    return Gaussian(vec3(parameter(0, i), parameter(1, i), parameter(2, i)),
                    vec3(parameter(3, i), parameter(4, i), parameter(5, i)),
                    vec4(parameter(6, i), parameter(7, i), parameter(8, i), parameter(9, i)), parameter(10, i),
                    vec3(parameter(11, i), parameter(12, i), parameter(13, i)));
}

void project_pinhole(inout Projection o) {
    o.inv_z = 1.0 / o.p.z;
    o.u = o.p.x * o.inv_z, o.v = o.p.y * o.inv_z;
    o.u_held = clamp(o.u, plan_slopes().x, plan_slopes().y);
    o.v_held = clamp(o.v, plan_slopes().z, plan_slopes().w);
    o.at = plan.lens.xy * vec2(o.u, o.v) + plan.lens.zw;
    o.depth = o.p.z;
    o.n0 = (o.turn.a - o.turn.c * o.u_held) * (plan_lens().x * o.inv_z);
    o.n1 = (o.turn.b - o.turn.c * o.v_held) * (plan_lens().y * o.inv_z);
}
void project_equirect(inout Projection o) {
    // At the poles the longitude's derivative diverges; the added 1e-6 m2 keeps it finite.
    const float h2 = o.p.x * o.p.x + o.p.z * o.p.z + 1e-6, r2 = h2 + o.p.y * o.p.y;
    o.h = sqrt(h2);
    o.inv_h2 = 1.0 / h2, o.inv_r2 = 1.0 / r2;
    const float east = plan_lens().x * o.inv_h2, south = plan_lens().y * o.inv_r2 * o.inv_h2 * o.h;
    o.slope_x = vec3(east * o.p.z, 0.0, -east * o.p.x);
    o.slope_y = vec3(-south * o.p.x * o.p.y, south * h2, -south * o.p.y * o.p.z);
    o.at = plan.lens.zw + plan.lens.xy * vec2(atan(o.p.x, o.p.z), -atan(-o.p.y, o.h));
    o.depth = sqrt(r2);
    o.n0 = o.slope_x.x * o.turn.a + o.slope_x.z * o.turn.c;
    o.n1 = o.slope_y.x * o.turn.a + o.slope_y.y * o.turn.b + o.slope_y.z * o.turn.c;
}

Projection project(Gaussian g, vec3 more_color) {
    Projection o;
    o.p = times(camera_rows(), g.mean) + vec3(plan_row_x().w, plan_row_y().w, plan_row_z().w);
    o.turn = times(camera_rows(), matrix_of(g.rotation));
    o.scale = exp(g.log_scale);
    o.inv_z = o.u = o.v = o.u_held = o.v_held = o.inv_h2 = o.inv_r2 = o.h = 0.0;
    o.slope_x = o.slope_y = vec3(0);
    if (flag(kEquirect)) project_equirect(o);
    else project_pinhole(o);
    o.m0 = o.n0 * o.scale, o.m1 = o.n1 * o.scale;
    const float low_pass = plan_weights().w;
    o.xx = dot(o.m0, o.m0) + low_pass, o.xy = dot(o.m0, o.m1), o.yy = dot(o.m1, o.m1) + low_pass;
    // det(m m^T) as a squared cross product is exact even for needles, where xx yy - xy^2 cancels.
    o.area = cross(o.m0, o.m1);
    const float area2 = dot(o.area, o.area), trace = o.xx + o.yy - 2.0 * low_pass;
    const float inv_det = 1.0 / (area2 + low_pass * trace + low_pass * low_pass);
    o.conic = vec3(o.yy, -o.xy, o.xx) * inv_det;
    const float odds_against = exp(-g.logit);
    o.opacity = 1.0 / (1.0 + odds_against);
    o.log2_opacity = -log2(1.0 + odds_against);
    if (flag(kAntialias)) o.log2_opacity += 0.5 * log2((area2 + kLeastArea2) * inv_det);
    o.color_raw = g.sh0 * kSh0 + 0.5 + more_color;
    return o;
}

// Squared Mahalanobis radius at which alpha falls to kMinAlpha.
float reach2_of(Projection p) { return 2.0 / kLog2E * (p.log2_opacity + kLog2Of255); }

// Written so that NaN, infinity and degenerate rotations fail.
bool is_drawable(Gaussian g, Projection p) {
    const float q2 = dot(g.rotation, g.rotation);
    return p.depth > kNearM && p.depth < 1e6 && q2 > 1e-20 && q2 < 1e20 && p.xx < 1e10 && p.yy < 1e10 &&
           p.conic.x > 0.0 && p.conic.z > 0.0 && reach2_of(p) > 0.0 && dot(p.color_raw, p.color_raw) < 1e8;
}

// Basis functions of degrees 1 to 3 (scene/sh.h) and, in slope(), their gradients, weighted.
void sh_basis(vec3 d, out float b[15]) {
    const float x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
    b[0] = -0.4886025119029199 * y, b[1] = 0.4886025119029199 * z, b[2] = -0.4886025119029199 * x;
    b[3] = 1.0925484305920792 * x * y, b[4] = -1.0925484305920792 * y * z;
    b[5] = 0.31539156525252005 * (2.0 * zz - xx - yy);
    b[6] = -1.0925484305920792 * x * z, b[7] = 0.5462742152960396 * (xx - yy);
    b[8] = -0.5900435899266435 * y * (3.0 * xx - yy), b[9] = 2.890611442640554 * x * y * z;
    b[10] = -0.4570457994644658 * y * (4.0 * zz - xx - yy);
    b[11] = 0.3731763325901154 * z * (2.0 * zz - 3.0 * xx - 3.0 * yy);
    b[12] = -0.4570457994644658 * x * (4.0 * zz - xx - yy), b[13] = 1.445305721320277 * z * (xx - yy);
    b[14] = -0.5900435899266435 * x * (xx - 3.0 * yy);
}
vec3 sh_slope(uint degree, vec3 d, float w[15]) {
    const float x = d.x, y = d.y, z = d.z, xx = x * x, yy = y * y, zz = z * z;
    vec3 g = vec3(-0.4886025119029199 * w[2], -0.4886025119029199 * w[0], 0.4886025119029199 * w[1]);
    if (degree >= 2) {
        const float a = 1.0925484305920792 * w[3], b = -1.0925484305920792 * w[4], e = 0.31539156525252005 * w[5];
        const float f = -1.0925484305920792 * w[6], h = 0.5462742152960396 * w[7];
        g += vec3(a * y - 2.0 * e * x + f * z + 2.0 * h * x, a * x + b * z - 2.0 * e * y - 2.0 * h * y,
                  b * y + 4.0 * e * z + f * x);
    }
    if (degree >= 3) {
        const float a = -0.5900435899266435 * w[8], b = 2.890611442640554 * w[9], e = -0.4570457994644658 * w[10];
        const float f = 0.3731763325901154 * w[11], h = -0.4570457994644658 * w[12], i = 1.445305721320277 * w[13];
        const float j = -0.5900435899266435 * w[14];
        g += vec3(6.0 * a * x * y + b * y * z - 2.0 * e * x * y - 6.0 * f * x * z + h * (4.0 * zz - 3.0 * xx - yy) +
                      2.0 * i * x * z + 3.0 * j * (xx - yy),
                  3.0 * a * (xx - yy) + b * x * z + e * (4.0 * zz - xx - 3.0 * yy) - 6.0 * f * y * z -
                      2.0 * h * x * y - 2.0 * i * y * z - 6.0 * j * x * y,
                  b * x * y + 8.0 * e * y * z + 3.0 * f * (2.0 * zz - xx - yy) + 8.0 * h * x * z + i * (xx - yy));
    }
    return g;
}

uint rest_functions(uint degree) { return (degree + 1) * (degree + 1) - 1; }
vec3 rest_of(uint i, uint k, uint n) {
    return vec3(t.rest.at[k * t.capacity + i], t.rest.at[(n + k) * t.capacity + i],
                t.rest.at[(2 * n + k) * t.capacity + i]);
}
// Direction from the camera to the splat, and 1 / distance.
vec4 sight_of(vec3 mean) {
    const vec3 d = mean - plan.center.xyz;
    const float inv = inversesqrt(dot(d, d) + 1e-20);
    return vec4(d * inv, inv);
}
vec3 more_color(uint i, vec3 direction) {
    vec3 sum = vec3(0);
    const uint n = rest_functions(plan.degree);
    if (n == 0) return sum;
    float basis[15];
    sh_basis(direction, basis);
    [[unroll]] for (uint k = 0; k < 15; ++k)
        if (k < n) sum += rest_of(i, k, n) * basis[k];
    return sum;
}
