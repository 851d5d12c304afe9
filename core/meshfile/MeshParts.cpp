// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshParts.h"

#include <QFile>
#include <QFileInfo>

#include <charconv>
#include <cmath>

namespace core {

Result<QByteArray> meshBytes(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    if (file.size() > mostMeshBytes)
        return unreadableMesh(path, Clause::saying("it is larger than 2 GiB"));
    QByteArray bytes = file.readAll();
    if (bytes.size() != file.size())
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    return bytes;
}

tl::unexpected<Error> unreadableMesh(const QString& path, const Clause& reason)
{
    return failure(ErrorCode::FileUnreadable, path, reason);
}

QString spaceIn(const QByteArray& text)
{
    const qsizetype at = text.indexOf("SPACE=");
    return at < 0 ? QString() : QString::fromLatin1(text.mid(at + 6, 3));
}

bool isNumber(QByteArrayView word, double& value)
{
    if (word.startsWith('+'))
        word = word.sliced(1);
    const char* end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, value);
    return parsed.ec == std::errc() && parsed.ptr == end && std::isfinite(value);
}

std::vector<QByteArrayView> wordsOf(QByteArrayView line)
{
    const auto isBlank = [](char character) {
        return character == ' ' || character == '\t' || character == '\r' || character == '\n';
    };
    std::vector<QByteArrayView> words;
    for (qsizetype at = 0; at < line.size();) {
        if (isBlank(line[at])) {
            ++at;
            continue;
        }
        qsizetype end = at;
        while (end < line.size() && !isBlank(line[end]))
            ++end;
        words.push_back(line.sliced(at, end - at));
        at = end;
    }
    return words;
}

void CommonColour::add(std::uint32_t rgb)
{
    m_same = m_same && m_rgb.value_or(rgb) == rgb;
    m_rgb = rgb;
}

ReadMeshPart partWithOwnVertices(const std::vector<glm::vec3>& vertices,
    const std::vector<std::uint32_t>& colours, std::vector<glm::uvec3> triangles)
{
    constexpr std::uint32_t unknown = UINT32_MAX;
    ReadMeshPart part;
    CommonColour colour;
    std::vector<std::uint32_t> own(vertices.size(), unknown);
    for (glm::uvec3& triangle : triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            std::uint32_t& number = own[triangle[corner]];
            if (number == unknown) {
                number = std::uint32_t(part.vertices.size());
                part.vertices.push_back(vertices[triangle[corner]]);
                if (!colours.empty())
                    colour.add(colours[triangle[corner]]);
            }
            triangle[corner] = number;
        }
    }
    part.rgb = colour.rgb();
    part.triangles = std::move(triangles);
    return part;
}

bool isMeshName(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    return ending == QLatin1String("stl") || ending == QLatin1String("obj")
        || ending == QLatin1String("ply") || ending == QLatin1String("glb");
}

Result<ReadMesh> readMesh(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    auto read = readStl;
    if (ending == QLatin1String("obj"))
        read = readObj;
    else if (ending == QLatin1String("ply"))
        read = readPly;
    else if (ending == QLatin1String("glb"))
        read = readGltf;
    return read(path);
}

} // namespace core
