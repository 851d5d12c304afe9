// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshParts.h"

#include <cmath>
#include <cstring>

namespace core {

namespace {

constexpr qsizetype header = 84;
constexpr qsizetype record = 50;

std::uint32_t countIn(const QByteArray& bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.constData() + 80, sizeof count);
    return count;
}

Result<ReadMesh> readBinary(const QByteArray& bytes, const QString& path)
{
    ReadMesh mesh{.space = spaceIn(bytes.left(80)), .parts = std::vector<ReadMeshPart>(1)};
    ReadMeshPart& part = mesh.parts.front();
    for (qsizetype at = header; at < bytes.size(); at += record) {
        const auto first = std::uint32_t(part.vertices.size());
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec3 place;
            std::memcpy(&place, bytes.constData() + at + 12 * (corner + 1), sizeof place);
            if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
                return unreadableMesh(path, Clause::saying("a corner that lies nowhere"));
            part.vertices.push_back(place);
        }
        part.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

/// "solid NAME", then "vertex X Y Z" three times a facet, then "endsolid"; what stands between says
/// nothing more.
Result<ReadMesh> readText(const QByteArray& bytes, const QString& path)
{
    bool ended = false;
    ReadMesh mesh{.space = {}, .parts = {}};
    for (qsizetype at = 0; at < bytes.size();) {
        qsizetype end = bytes.indexOf('\n', at);
        end = end < 0 ? bytes.size() : end;
        const QByteArray line = bytes.mid(at, end - at).trimmed();
        at = end + 1;
        if (line.startsWith("end") && line.contains("solid"))
            ended = true;
        if (line.startsWith("solid")) {
            ended = false;
            mesh.parts.emplace_back();
            const QString space = spaceIn(line);
            mesh.parts.back().name = QString::fromUtf8(line.mid(5))
                                         .remove(QStringLiteral("SPACE=") + space)
                                         .simplified();
            if (mesh.space.isEmpty())
                mesh.space = space;
            continue;
        }
        if (!line.startsWith("vertex"))
            continue;
        const std::vector<QByteArrayView> words = wordsOf(line);
        glm::dvec3 place;
        if (mesh.parts.empty() || words.size() != 4 || !isNumber(words[1], place.x)
            || !isNumber(words[2], place.y) || !isNumber(words[3], place.z))
            return unreadableMesh(path, Clause::saying("a corner that lies nowhere"));
        ReadMeshPart& part = mesh.parts.back();
        part.vertices.emplace_back(place);
        const auto count = std::uint32_t(part.vertices.size());
        if (count % 3 == 0)
            part.triangles.emplace_back(count - 3, count - 2, count - 1);
    }
    for (const ReadMeshPart& part : mesh.parts) {
        if (part.vertices.size() % 3 != 0 || !ended)
            return failure(
                ErrorCode::FileTruncated, path, Clause::saying("it ends inside a solid"));
    }
    return mesh;
}

} // namespace

Result<ReadMesh> readStl(const QString& path)
{
    const Result<QByteArray> bytes = meshBytes(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    // Binary files may begin with "solid", too: their size tells.
    if (bytes->size() >= header && bytes->size() == header + record * qsizetype(countIn(*bytes)))
        return readBinary(*bytes, path);
    if (bytes->trimmed().startsWith("solid") && bytes->contains("facet"))
        return readText(*bytes, path);
    return unreadableMesh(path, Clause::saying("no STL, or not as many triangles as it says"));
}

} // namespace core
