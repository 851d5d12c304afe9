// SPDX-License-Identifier: Apache-2.0
#include "core/masks/StoredGrid.h"

#include "core/metaimage/MetaImageReader.h"
#include "core/nifti/NiftiReader.h"
#include "core/nrrd/NrrdReader.h"

namespace core {

namespace {

Result<StoredGrid> storedIn(GridFile grid, const Progress& progress)
{
    Result<VoxelBytes> bytes = readVoxels(grid.voxels, progress);
    if (!bytes)
        return tl::unexpected(bytes.error());
    StoredGrid stored{.geometry = std::move(grid.geometry), .problems = std::move(grid.problems)};
    stored.type = grid.voxels.type;
    stored.owned = std::move(bytes->data);
    stored.bytes = {stored.owned.get(), bytes->size};
    return stored;
}

} // namespace

Result<StoredGrid> readStoredGrid(const QString& path, const Progress& progress)
{
    if (isNiftiName(path)) {
        const Result<SeriesEntry> entry = readNiftiEntry(path);
        if (!entry)
            return tl::unexpected(entry.error());
        if (!entry->times.isEmpty())
            return failure(ErrorCode::UnsupportedFormat, path,
                Clause::saying("it holds %1 volumes", entry->times.size()));
        Result<NiftiNumbers> voxels = readNiftiNumbers(*entry);
        if (!voxels)
            return tl::unexpected(voxels.error());
        StoredGrid stored{.geometry = entry->geometry, .problems = entry->problems};
        stored.bytesOfNifti = std::move(voxels->bytes);
        stored.bytes = stored.bytesOfNifti;
        stored.type = voxels->type;
        stored.slope = voxels->slope;
        stored.intercept = voxels->intercept;
        return stored;
    }
    if (isMetaImageName(path)) {
        Result<GridFile> grid = readMetaImage(path);
        if (!grid)
            return tl::unexpected(grid.error());
        return storedIn(*std::move(grid), progress);
    }
    Result<NrrdLayers> nrrd = readNrrdLayers(path);
    if (!nrrd)
        return tl::unexpected(nrrd.error());
    Result<StoredGrid> stored = storedIn(std::move(nrrd->grid), progress);
    if (stored) {
        stored->layers = nrrd->layers;
        stored->keyValues = std::move(nrrd->keyValues);
    }
    return stored;
}

bool StoredGrid::holdsShares() const
{
    if (!isFloating(type) && slope == 1.0 && intercept == 0.0)
        return false;
    const StoredAt stored = storedAtFor(type);
    bool between = false;
    for (std::size_t i = 0; i < voxels() * std::size_t(layers); ++i) {
        const double number = slope * stored(bytes.data(), i) + intercept;
        if (!(number >= -slack && number <= 1.0 + slack))
            return false;
        between = between || (number > slack && number < 1.0 - slack);
    }
    return between;
}

} // namespace core
