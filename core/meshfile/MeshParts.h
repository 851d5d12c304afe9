// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/meshfile/MeshReader.h"

#include <QByteArray>

#include <vector>

namespace core {

// What the readers of the formats share.

/// A surface is never larger: more than any mask needs, less than memory.
constexpr qsizetype mostMeshBytes = qsizetype(2) << 30;

[[nodiscard]] Result<QByteArray> meshBytes(const QString& path);

[[nodiscard]] tl::unexpected<Error> unreadableMesh(const QString& path, const char* reason);

/// Of "… SPACE=LPS …", as 3D Slicer and writers of our own have it; empty if it is not there.
[[nodiscard]] QString spaceIn(const QByteArray& text);

/// A number as text, whole; not finite: none.
[[nodiscard]] bool isNumber(QByteArrayView word, double& value);

/// Words of a line, apart by blanks.
[[nodiscard]] std::vector<QByteArrayView> wordsOf(QByteArrayView line);

/// Colours of vertices become one of their part, if it is the same at all of them.
class CommonColour {
public:
    void add(std::uint32_t rgb);
    [[nodiscard]] std::optional<std::uint32_t> rgb() const { return m_same ? m_rgb : std::nullopt; }

private:
    std::optional<std::uint32_t> m_rgb;
    bool m_same = true;
};

/// A part of faces that count vertices of the whole file: takes those that its triangles name.
/// @param colours one a vertex, or none at all
[[nodiscard]] ReadMeshPart partWithOwnVertices(const std::vector<glm::vec3>& vertices,
    const std::vector<std::uint32_t>& colours, std::vector<glm::uvec3> triangles);

} // namespace core
