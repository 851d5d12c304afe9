// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/refine/mesh/SimplexMesh.h"

#include <QString>

namespace core {

/// What a file says of a surface besides its shape.
struct SurfaceFileFacts {
    QString name; ///< of the segment
    std::uint32_t rgb = 0; ///< 0xRRGGBB
    std::uint8_t label = 1;
};

/// The endings of the files that writeSurfaceFile() knows: "stl", "ply", "obj", "glb".
[[nodiscard]] const std::vector<QString>& surfaceFileEndings();

/// Writes a surface as triangles (SurfacePart.h), in LPS mm, in the format that the file's ending
/// names. Any thread; seconds for a large surface. Errors: UnsupportedFormat; FileExists;
/// FileUnwritable.
/// @param replaces a file of that name
[[nodiscard]] Result<void> writeSurfaceFile(
    const SimplexMesh& mesh, const SurfaceFileFacts& facts, const QString& path, bool replaces);

} // namespace core
