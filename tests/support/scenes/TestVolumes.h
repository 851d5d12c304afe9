// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reference/fields/DenseFields.h"

#include <cstdint>
#include <random>

namespace test {

using Codes = reference::DenseArray<std::uint16_t>;
using Bytes = reference::DenseArray<std::uint8_t>;
using Random = std::mt19937;

/// The code of the corridors, balls, slabs and shells below. Around them the code is 0, or noise
/// below half of it.
constexpr std::uint16_t tissueCode = 1000;

/// An integer in [low, high], the same on every platform (standard distributions are not).
[[nodiscard]] int randomInt(Random& random, int low, int high);
/// In [0, 1), likewise.
[[nodiscard]] double randomUnit(Random& random);
[[nodiscard]] glm::ivec3 randomVoxel(Random& random, const glm::ivec3& size);

[[nodiscard]] Codes constantVolume(const glm::ivec3& size, std::uint16_t code);
/// Independent random voxels, 0 … highest.
[[nodiscard]] Codes noiseVolume(const glm::ivec3& size, int highest, Random& random);
/// Tissue where x + y + z is even: no two tissue voxels share a face.
[[nodiscard]] Codes checkerboard(const glm::ivec3& size);
/// A corridor, one voxel wide, that winds from (0, 0, 0) through the whole volume.
[[nodiscard]] Codes spiralCorridor(const glm::ivec3& size);
/// The same, but every step along x also goes diagonally to the next row: only growth over edges
/// can follow it.
[[nodiscard]] Codes zigzagCorridor(const glm::ivec3& size);
/// Overlapping balls of tissue in noise.
[[nodiscard]] Codes balls(const glm::ivec3& size, int count, Random& random);
/// Two concentric shells of tissue with grey inside: a skull, roughly.
[[nodiscard]] Codes shells(const glm::ivec3& size);
/// Tissue where `first` ≤ coordinate ≤ `last` along an axis, 0 elsewhere.
[[nodiscard]] Codes slab(const glm::ivec3& size, int axis, int first, int last);

/// @p count random boxes of the labels 0 … 4, one over the other, as if painted; 0 elsewhere.
[[nodiscard]] Bytes labelBoxes(const glm::ivec3& size, int count, Random& random);

/// The bricks of a field of bytes, whole, for core::SwapBricks.
[[nodiscard]] std::vector<core::BrickImage> bricksOf(
    const Bytes& bytes, core::Field field, std::uint8_t plane);

} // namespace test
