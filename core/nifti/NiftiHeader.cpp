// SPDX-License-Identifier: Apache-2.0
#include "core/nifti/NiftiHeader.h"

#include <QtEndian>

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace core {

namespace {

// Offsets of nifti1.h.
constexpr int atSizeOfHeader = 0;
constexpr int atRegular = 38;
constexpr int atDim = 40;
constexpr int atIntentCode = 68;
constexpr int atDataType = 70;
constexpr int atBitsPerVoxel = 72;
constexpr int atPixDim = 76;
constexpr int atVoxelOffset = 108;
constexpr int atSlope = 112;
constexpr int atUnits = 123;
constexpr int atDescription = 148;
constexpr int atQformCode = 252;
constexpr int atSformCode = 254;
constexpr int atQuaternion = 256;
constexpr int atQoffset = 268;
constexpr int atSrow = 280;
constexpr int atMagic = 344;

constexpr std::int16_t scannerAnatomical = 1;
constexpr std::int16_t intentLabel = 1002;
constexpr char unitMillimetre = 2;

/// A qform further from the affine than this at any corner is left out.
constexpr double qformToleranceMm = 1e-3;

void put(NiftiHeader& header, int offset, std::int16_t value)
{
    qToLittleEndian(value, header.bytes.data() + offset);
}

void put(NiftiHeader& header, int offset, std::int32_t value)
{
    qToLittleEndian(value, header.bytes.data() + offset);
}

void put(NiftiHeader& header, int offset, float value)
{
    qToLittleEndian(std::bit_cast<std::uint32_t>(value), header.bytes.data() + offset);
}

/// nifti1.h, method 2, as a reader computes it from the stored floats.
glm::dmat3 rotationOf(const glm::vec3& bcd)
{
    const double b = bcd.x, c = bcd.y, d = bcd.z;
    const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
    return glm::mat3_cast(glm::dquat(a, b, c, d));
}

/// Rotation and scales of an affine without shear.
struct Qform {
    glm::vec3 bcd{0.0F};
    float qfac = 1.0F;
    double errorMm = 0.0; ///< at the corner that is furthest off
};

Qform fitQform(const glm::dmat3& ras, const glm::ivec3& size)
{
    glm::dvec3 spacing;
    glm::dmat3 rotation;
    for (int axis = 0; axis < 3; ++axis) {
        spacing[axis] = glm::length(ras[axis]);
        rotation[axis] = ras[axis] / spacing[axis];
    }
    Qform best;
    if (glm::determinant(rotation) < 0.0) {
        best.qfac = -1.0F;
        rotation[2] = -rotation[2];
    }
    glm::dquat turn = glm::normalize(glm::quat_cast(rotation));
    if (turn.w < 0.0)
        turn = -turn;
    const glm::vec3 rounded(float(turn.x), float(turn.y), float(turn.z));

    const auto errorOf = [&](const glm::vec3& bcd) {
        const glm::dmat3 read = rotationOf(bcd);
        double worst = 0.0;
        for (int corner = 1; corner < 8; ++corner) {
            glm::dvec3 off(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                if ((corner & (1 << axis)) == 0)
                    continue;
                const double sign = axis == 2 ? double(best.qfac) : 1.0;
                off +=
                    double(size[axis]) * (read[axis] * (sign * float(spacing[axis])) - ras[axis]);
            }
            worst = std::max(worst, glm::length(off));
        }
        return worst;
    };
    // The real part is not stored but follows from the other three; near a half turn their rounding
    // is magnified, so the neighbouring floats are tried too.
    best.bcd = rounded;
    best.errorMm = errorOf(rounded);
    constexpr int reach = 2;
    for (int b = -reach; b <= reach; ++b) {
        for (int c = -reach; c <= reach; ++c) {
            for (int d = -reach; d <= reach; ++d) {
                const auto step = [](float value, int steps) {
                    for (int i = 0; i < std::abs(steps); ++i)
                        value = std::nextafter(value, steps > 0 ? 2.0F : -2.0F);
                    return value;
                };
                const glm::vec3 candidate(
                    step(rounded.x, b), step(rounded.y, c), step(rounded.z, d));
                const double error = errorOf(candidate);
                if (error < best.errorMm) {
                    best.bcd = candidate;
                    best.errorMm = error;
                }
            }
        }
    }
    return best;
}

} // namespace

NiftiHeader makeNiftiHeader(const VolumeGeometry& geometry, NiftiHeader::DataType type,
    const QByteArray& description, bool labels)
{
    NiftiHeader header;
    put(header, atSizeOfHeader, std::int32_t(348));
    header.bytes[atRegular] = 'r';
    put(header, atDim, std::int16_t(3));
    for (int axis = 0; axis < 7; ++axis)
        put(header, atDim + 2 * (axis + 1), std::int16_t(axis < 3 ? geometry.size[axis] : 1));
    const bool bytes = type == NiftiHeader::DataType::UInt8;
    put(header, atIntentCode, bytes && labels ? intentLabel : std::int16_t(0));
    put(header, atDataType, std::int16_t(type));
    put(header, atBitsPerVoxel,
        std::int16_t(bytes                               ? 8
                : type == NiftiHeader::DataType::Float32 ? 32
                                                         : 16));
    put(header, atVoxelOffset, float(NiftiHeader::voxelOffset));
    put(header, atSlope, 1.0F);
    header.bytes[atUnits] = unitMillimetre;
    std::copy_n(description.constData(), std::min<qsizetype>(description.size(), 79),
        header.bytes.data() + atDescription);
    std::memcpy(header.bytes.data() + atMagic, "n+1", 4);

    glm::dmat4 ras = geometry.indexToWorld;
    for (int column = 0; column < 4; ++column) {
        ras[column].x = -ras[column].x;
        ras[column].y = -ras[column].y;
    }
    put(header, atSformCode, scannerAnatomical);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            put(header, atSrow + 16 * row + 4 * column, float(ras[column][row]));
    }

    const Qform qform = fitQform(glm::dmat3(ras), geometry.size);
    header.qform = qform.errorMm <= qformToleranceMm;
    put(header, atPixDim, header.qform ? qform.qfac : 1.0F);
    const glm::dvec3 spacing = geometry.spacingMm();
    for (int axis = 0; axis < 7; ++axis)
        put(header, atPixDim + 4 * (axis + 1), axis < 3 ? float(spacing[axis]) : 1.0F);
    if (header.qform) {
        put(header, atQformCode, scannerAnatomical);
        for (int part = 0; part < 3; ++part) {
            put(header, atQuaternion + 4 * part, qform.bcd[part]);
            put(header, atQoffset + 4 * part, float(ras[3][part]));
        }
    }
    return header;
}

} // namespace core
