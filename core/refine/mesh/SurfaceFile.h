// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMesh.h"

#include <QString>

namespace core {

/// What a file states about a surface besides its shape.
struct SurfaceFileFacts {
    QString name; ///< name of the segment
    std::uint32_t rgb = 0; ///< 0xRRGGBB
    std::uint8_t label = 1;
};

/// The endings of the files that writeSurfaceFile() knows: "stl", "ply", "obj", "glb".
[[nodiscard]] const std::vector<QString>& surfaceFileEndings();

/// Writes a surface as triangles (SurfacePart.h), in LPS mm, in the format that the ending of the
/// path names. Blocks, for seconds if the surface is large; any thread. Errors: UnsupportedFormat;
/// FileExists; FileUnwritable.
/// @param replaces whether an existing file of that name is replaced
[[nodiscard]] Result<void> writeSurfaceFile(
    const SimplexMesh& mesh, const SurfaceFileFacts& facts, const QString& path, bool replaces);

} // namespace core
