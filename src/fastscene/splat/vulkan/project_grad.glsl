// From the sums over a splat's pixels back to its parameters (splat/project_grad.h).

// With g = dL/d(ln alpha) at a pixel and d = pixel center - splat center.
struct PixelSums {
    float g;
    vec2 g_d;
    vec3 g_dd;  // xx, xy, yy
    vec3 color;
    float weight, error, depth;
};

vec4 quaternion_grad(vec4 q, Rows g) {
    const float inv = inversesqrt(dot(q, q));
    const vec4 n = q * inv;
    const float w = n.x, x = n.y, y = n.z, z = n.w;
    const float a = g.c.y - g.b.z, b = g.a.z - g.c.x, c = g.b.x - g.a.y;
    const float d = g.a.y + g.b.x, e = g.a.z + g.c.x, f = g.b.z + g.c.y;
    const vec4 all = 2.0 * vec4(x * a + y * b + z * c, w * a + y * d + z * e - 2.0 * x * (g.b.y + g.c.z),
                                w * b + x * d + z * f - 2.0 * y * (g.a.x + g.c.z),
                                w * c + x * e + y * f - 2.0 * z * (g.a.x + g.b.y));
    // Only the component orthogonal to q rotates; the parallel one changes q's length.
    return (all - n * dot(all, n)) * inv;
}

vec3 pinhole_grad(Projection p, vec2 screen, vec3 gn0, vec3 gn1, out Rows g_turn) {
    const vec3 gw0 = gn0 * (plan_lens().x * p.inv_z), gw1 = gn1 * (plan_lens().y * p.inv_z);
    g_turn = Rows(gw0, gw1, -(gw0 * p.u_held + gw1 * p.v_held));
    const bool u_free = p.u >= plan_slopes().x && p.u <= plan_slopes().y;
    const bool v_free = p.v >= plan_slopes().z && p.v <= plan_slopes().w;
    const float gu = plan_lens().x * screen.x - (u_free ? dot(gw0, p.turn.c) : 0.0);
    const float gv = plan_lens().y * screen.y - (v_free ? dot(gw1, p.turn.c) : 0.0);
    // u = x / z, v = y / z, n ~ 1 / z.
    return p.inv_z * vec3(gu, gv, -(gu * p.u + gv * p.v + dot(gn0, p.n0) + dot(gn1, p.n1)));
}

// The part that comes from the slopes changing with the point (splat/camera_slopes.h).
vec3 slopes_grad(Projection p, vec3 g0, vec3 g1) {
    const vec3 at = p.p;
    const float a0 = dot(g0, p.turn.a), a2 = dot(g0, p.turn.c), b0 = dot(g1, p.turn.a), b1 = dot(g1, p.turn.b),
                b2 = dot(g1, p.turn.c);
    const float east = plan_lens().x * p.inv_h2, south = plan_lens().y * p.inv_r2 * p.inv_h2 * p.h;
    const float e = 2.0 * p.inv_h2 * dot(g0, p.n0), r = 2.0 * p.inv_r2 * dot(g1, p.n1), h = p.inv_h2 * dot(g1, p.n1);
    return vec3(-(east * a2) - e * at.x + south * (2.0 * at.x * b1 - at.y * b0) - (r + h) * at.x,
                -(south * (at.x * b0 + at.z * b2)) - r * at.y,
                east * a0 - e * at.z + south * (2.0 * at.z * b1 - at.y * b2) - (r + h) * at.z);
}
vec3 equirect_grad(Projection p, vec2 screen, vec3 gn0, vec3 gn1, out Rows g_turn) {
    g_turn = Rows(gn0 * p.slope_x.x + gn1 * p.slope_y.x, gn1 * p.slope_y.y, gn0 * p.slope_x.z + gn1 * p.slope_y.z);
    return p.slope_x * screen.x + p.slope_y * screen.y + slopes_grad(p, gn0, gn1);
}

// dL/d(screen position), pixels.
vec2 screen_grad(Projection p, PixelSums s) {
    return vec2(dot(p.conic.xy, s.g_d), dot(p.conic.yz, s.g_d));
}

Gaussian project_grad(Gaussian g, Projection p, PixelSums s) {
    Gaussian result;
    const vec2 screen = screen_grad(p, s);
    // Conic to covariance: dL/dcov = -K (dL/dK) K with K the (symmetric) conic.
    const vec3 k = -0.5 * s.g_dd;
    const float a = p.conic.x, b = p.conic.y, c = p.conic.z;
    const float t00 = k.x * a + k.y * b, t01 = k.x * b + k.y * c, t10 = k.y * a + k.z * b, t11 = k.y * b + k.z * c;
    vec3 h = -vec3(a * t00 + b * t10, a * t01 + b * t11, b * t01 + c * t11);
    vec3 g_area = vec3(0);
    if (flag(kAntialias)) {  // ln alpha holds ln(area / sqrt(det)); d ln sqrt(det) / dcov = conic / 2
        h -= 0.5 * s.g * p.conic;
        g_area = p.area * (s.g / (dot(p.area, p.area) + kLeastArea2));
    }
    // Covariance to its factor m = n * scale.
    vec3 gm0 = 2.0 * (p.m0 * h.x + p.m1 * h.y), gm1 = 2.0 * (p.m0 * h.y + p.m1 * h.z);
    if (flag(kAntialias)) gm0 += cross(p.m1, g_area), gm1 += cross(g_area, p.m0);
    result.log_scale = gm0 * p.m0 + gm1 * p.m1;
    const vec3 gn0 = gm0 * p.scale, gn1 = gm1 * p.scale;

    Rows g_turn;
    vec3 gp;
    if (flag(kEquirect)) gp = equirect_grad(p, screen, gn0, gn1, g_turn) + p.p * (s.depth / p.depth);
    else gp = pinhole_grad(p, screen, gn0, gn1, g_turn) + vec3(0, 0, s.depth);
    result.mean = times_transposed(camera_rows(), gp);
    result.rotation = quaternion_grad(g.rotation, times_transposed(camera_rows(), g_turn));
    result.logit = s.g * (1.0 - p.opacity);
    result.sh0 = mix(vec3(0), s.color * kSh0, greaterThan(p.color_raw, vec3(0)));
    return result;
}
