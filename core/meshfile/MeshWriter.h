// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <QString>

#include <cstdint>
#include <vector>

namespace core {

/// One surface to be written: mm, triangles counter-clockwise seen from outside.
struct MeshPart {
    QString name;
    std::uint32_t rgb = 0; ///< 0xRRGGBB
    std::uint8_t label = 0;
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

// Common to all four: they create or overwrite the file; @p space ("LPS", "RAS") is written into
// the file's comment and names the axes of the coordinates. Errors: FileUnwritable,
// UnsupportedFormat (more triangles or vertices than the format can count).

/// Binary; all parts in one surface, since the format has no parts. "SPACE=LPS" is in the header.
Result<void> writeStl(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// One object per part; vertices with their colour.
Result<void> writeObj(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// Binary, little endian; vertices with their colour, faces with their part's label, and for each
/// part a comment that says which faces belong to it.
Result<void> writePly(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);
/// Binary (.glb), one node and one material per part. Coordinates are as in the other formats; the
/// parent node rotates and scales them to glTF's metres with Y up (glTF 2.0, 3.6.2).
Result<void> writeGltf(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space);

} // namespace core
