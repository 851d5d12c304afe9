// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"
#include "core/voxelfile/StoredScalars.h"

#include <QByteArray>

#include <map>
#include <memory>
#include <span>
#include <vector>

namespace core {

/// The numbers of a NIfTI, NRRD or MetaImage file as they are stored, on their own grid: labels,
/// shares of voxels or probabilities. Several layers have several numbers a voxel.
struct StoredGrid {
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems;
    std::unique_ptr<char[]> owned; ///< what bytes refers to, or bytesOfNifti
    std::vector<char> bytesOfNifti;
    std::span<const char> bytes;
    ScalarType type = ScalarType::UInt8;
    double slope = 1.0; ///< value = slope · stored + intercept
    double intercept = 0.0;
    int layers = 1;
    std::map<QByteArray, QByteArray> keyValues; ///< of an NRRD's header

    [[nodiscard]] std::size_t voxels() const
    {
        return bytes.size() / bytesPerScalar(type) / std::size_t(layers);
    }
    [[nodiscard]] double value(std::size_t voxel, int layer) const
    {
        return slope
            * storedAtFor(type)(bytes.data(), voxel * std::size_t(layers) + std::size_t(layer))
            + intercept;
    }
    /// Programs that add up or scale in floats leave shares a little beside 0 and 1.
    static constexpr double slack = 1e-3;
    /// Whether the numbers are shares of voxels or probabilities: all from 0 to 1, and not only
    /// these two. Cost: one pass, which mostly ends early.
    [[nodiscard]] bool holdsShares() const;
};

/// Reads a file that its name tells to be one of the three. The file is closed afterwards. Any
/// thread. Errors: those of the readers.
[[nodiscard]] Result<StoredGrid> readStoredGrid(const QString& path, const Progress& progress);

} // namespace core
