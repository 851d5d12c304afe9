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

/// The numbers of a NIfTI, NRRD or MetaImage file as they are stored, on the file's own grid:
/// labels, shares of voxels or probabilities. With several layers there are several numbers per
/// voxel.
struct StoredGrid {
    VolumeGeometry geometry;
    std::vector<VolumeProblem> problems;
    std::unique_ptr<char[]> owned; ///< owns the memory of `bytes`, unless bytesOfNifti does
    std::vector<char> bytesOfNifti;
    std::span<const char> bytes;
    ScalarType type = ScalarType::UInt8;
    double slope = 1.0; ///< value = slope · stored + intercept
    double intercept = 0.0;
    int layers = 1;
    std::map<QByteArray, QByteArray> keyValues; ///< key/value pairs from the header of an NRRD

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
    /// Tolerance for rounding: programs that compute shares in floats miss 0 and 1 by a little.
    static constexpr double slack = 1e-3;
    /// Whether the numbers are shares of voxels or probabilities: all lie between 0 and 1, and not
    /// all are 0 or 1. Cost: at most one pass, which mostly ends early.
    [[nodiscard]] bool holdsShares() const;
};

/// Reads a file; its name tells which of the three formats it has. The file is closed afterwards.
/// Blocks; any thread. Errors: those of the readers.
[[nodiscard]] Result<StoredGrid> readStoredGrid(const QString& path, const Progress& progress);

} // namespace core
