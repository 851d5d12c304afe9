// SPDX-License-Identifier: Apache-2.0
#include "core/demo/Noise.h"

namespace core::demo {

namespace {

/// Three bytes of a hash as a direction; its length varies, which does no harm here.
glm::vec3 latticeGradient(std::int32_t x, std::int32_t y, std::int32_t z)
{
    const std::uint32_t word = hash(x, y, z);
    return glm::vec3(static_cast<float>(word & 255U), static_cast<float>((word >> 8) & 255U),
               static_cast<float>((word >> 16) & 255U))
        * (2.0F / 255.0F)
        - 1.0F;
}

} // namespace

NoiseSample noise(const glm::vec3& p, int seed)
{
    const glm::vec3 cell = glm::floor(p);
    const glm::vec3 f = p - cell;
    const auto x = static_cast<std::int32_t>(cell.x) + seed * 101;
    const auto y = static_cast<std::int32_t>(cell.y) + seed * 57;
    const auto z = static_cast<std::int32_t>(cell.z);
    const glm::vec3 u = f * f * f * (f * (f * 6.0F - 15.0F) + 10.0F);
    const glm::vec3 du = 30.0F * f * f * (f * (f - 2.0F) + 1.0F);

    glm::vec3 slope(0.0F);
    float value = 0.0F;
    glm::vec3 across(0.0F);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 at(step);
        const glm::vec3 gradient = latticeGradient(x + step.x, y + step.y, z + step.z);
        const float height = glm::dot(gradient, f - at);
        const glm::vec3 share = glm::mix(1.0F - u, u, at);
        const glm::vec3 sign = at * 2.0F - 1.0F;
        const float weight = share.x * share.y * share.z;
        value += weight * height;
        slope += weight * gradient;
        across +=
            height * sign * glm::vec3(share.y * share.z, share.x * share.z, share.x * share.y);
    }
    // Scaled to about −1 … 1.
    constexpr float scale = 1.5F;
    return {scale * value, scale * (slope + du * across)};
}

} // namespace core::demo
