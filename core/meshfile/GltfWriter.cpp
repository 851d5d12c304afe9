// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshNames.h"
#include "core/meshfile/MeshWriter.h"
#include "core/voxelfile/PackedOutput.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <bit>
#include <cmath>
#include <limits>

namespace core {

static_assert(std::endian::native == std::endian::little, "what is written is little endian");

namespace {

constexpr int floats = 5126; // glTF 2.0, 3.6.2.2
constexpr int unsignedInts = 5125;
constexpr int arrayBuffer = 34962;
constexpr int elementArrayBuffer = 34963;

/// A share of light for a byte of sRGB (IEC 61966-2-1).
double linear(std::uint32_t byte)
{
    const double share = double(byte) / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

QJsonArray listOf(const glm::vec3& vector)
{
    return {double(vector.x), double(vector.y), double(vector.z)};
}

/// Millimetres to metres; superior is up (Y), anterior towards the viewer (Z); by columns.
QJsonArray uprightMetres(const QString& space)
{
    const double m = 0.001;
    const double front = space == QLatin1String("LPS") ? -m : m;
    const double left = space == QLatin1String("LPS") ? m : -m;
    return {left, 0, 0, 0, 0, 0, front, 0, 0, m, 0, 0, 0, 0, 0, 1};
}

/// Of all triangles at a vertex, weighted by their areas.
std::vector<glm::vec3> normalsOf(const MeshPart& part)
{
    std::vector<glm::vec3> normals(part.vertices.size(), glm::vec3(0.0F));
    for (const glm::uvec3& triangle : part.triangles) {
        const glm::vec3& a = part.vertices[triangle.x];
        const glm::vec3 cross =
            glm::cross(part.vertices[triangle.y] - a, part.vertices[triangle.z] - a);
        for (int i = 0; i < 3; ++i)
            normals[triangle[i]] += cross;
    }
    for (glm::vec3& normal : normals) {
        const float length = glm::length(normal);
        normal = length > 0.0F ? normal / length : glm::vec3(0.0F, 0.0F, 1.0F);
    }
    return normals;
}

struct GltfDocument {
    QJsonArray views;
    QJsonArray accessors;
    QJsonArray materials;
    QJsonArray meshes;
    QJsonArray nodes;
    std::uint64_t size = 0;

    /// @return its number
    int addAccessor(int target, int component, const QString& type, std::size_t count,
        std::size_t bytes, const QJsonObject& bounds = {})
    {
        views.append(
            QJsonObject{{QStringLiteral("buffer"), 0}, {QStringLiteral("byteOffset"), qint64(size)},
                {QStringLiteral("byteLength"), qint64(bytes)}, {QStringLiteral("target"), target}});
        QJsonObject accessor = bounds;
        accessor[QStringLiteral("bufferView")] = views.size() - 1;
        accessor[QStringLiteral("componentType")] = component;
        accessor[QStringLiteral("count")] = qint64(count);
        accessor[QStringLiteral("type")] = type;
        accessors.append(accessor);
        size += bytes;
        return int(accessors.size()) - 1;
    }

    void add(const MeshPart& part)
    {
        glm::vec3 least(std::numeric_limits<float>::max());
        glm::vec3 most(std::numeric_limits<float>::lowest());
        for (const glm::vec3& vertex : part.vertices) {
            least = glm::min(least, vertex);
            most = glm::max(most, vertex);
        }
        const std::size_t bytes = part.vertices.size() * sizeof(glm::vec3);
        const int position =
            addAccessor(arrayBuffer, floats, QStringLiteral("VEC3"), part.vertices.size(), bytes,
                {{QStringLiteral("min"), listOf(least)}, {QStringLiteral("max"), listOf(most)}});
        const int normal =
            addAccessor(arrayBuffer, floats, QStringLiteral("VEC3"), part.vertices.size(), bytes);
        const int indices = addAccessor(elementArrayBuffer, unsignedInts, QStringLiteral("SCALAR"),
            3 * part.triangles.size(), part.triangles.size() * sizeof(glm::uvec3));
        const QString name = oneLine(part.name);
        materials.append(QJsonObject{{QStringLiteral("name"), name},
            {QStringLiteral("pbrMetallicRoughness"),
                QJsonObject{{QStringLiteral("baseColorFactor"),
                                QJsonArray{linear((part.rgb >> 16) & 0xffU),
                                    linear((part.rgb >> 8) & 0xffU), linear(part.rgb & 0xffU), 1}},
                    {QStringLiteral("metallicFactor"), 0},
                    {QStringLiteral("roughnessFactor"), 0.6}}}});
        meshes.append(QJsonObject{{QStringLiteral("name"), name},
            {QStringLiteral("primitives"),
                QJsonArray{QJsonObject{{QStringLiteral("attributes"),
                                           QJsonObject{{QStringLiteral("POSITION"), position},
                                               {QStringLiteral("NORMAL"), normal}}},
                    {QStringLiteral("indices"), indices},
                    {QStringLiteral("material"), materials.size() - 1}}}}});
        nodes.append(QJsonObject{{QStringLiteral("name"), name},
            {QStringLiteral("mesh"), meshes.size() - 1},
            {QStringLiteral("extras"), QJsonObject{{QStringLiteral("label"), int(part.label)}}}});
    }

    [[nodiscard]] QByteArray json(const QString& space) const
    {
        QJsonArray children;
        for (int node = 1; node <= nodes.size(); ++node)
            children.append(node);
        QJsonArray all{
            QJsonObject{{QStringLiteral("name"), QStringLiteral("Segments, mm in ") + space},
                {QStringLiteral("matrix"), uprightMetres(space)},
                {QStringLiteral("children"), children}}};
        for (const QJsonValue& node : nodes)
            all.append(node);
        const QJsonObject document{
            {QStringLiteral("asset"),
                QJsonObject{{QStringLiteral("version"), QStringLiteral("2.0")},
                    {QStringLiteral("generator"), QStringLiteral("Burin")},
                    {QStringLiteral("extras"),
                        QJsonObject{{QStringLiteral("space"), space},
                            {QStringLiteral("unit"), QStringLiteral("mm")}}}}},
            {QStringLiteral("scene"), 0},
            {QStringLiteral("scenes"),
                QJsonArray{QJsonObject{{QStringLiteral("nodes"), QJsonArray{0}}}}},
            {QStringLiteral("nodes"), all}, {QStringLiteral("meshes"), meshes},
            {QStringLiteral("materials"), materials}, {QStringLiteral("accessors"), accessors},
            {QStringLiteral("bufferViews"), views},
            {QStringLiteral("buffers"),
                QJsonArray{QJsonObject{{QStringLiteral("byteLength"), qint64(size)}}}}};
        QByteArray text = QJsonDocument(document).toJson(QJsonDocument::Compact);
        while (text.size() % 4 != 0)
            text += ' ';
        return text;
    }
};

} // namespace

Result<void> writeGltf(
    const QString& path, const std::vector<MeshPart>& parts, const QString& space)
{
    GltfDocument document;
    for (const MeshPart& part : parts)
        document.add(part);
    const QByteArray json = document.json(space);
    constexpr std::uint64_t headers = 28;
    const std::uint64_t total = headers + std::uint64_t(json.size()) + document.size;
    if (total > std::numeric_limits<std::uint32_t>::max())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("the surfaces fill more than 4 GiB; export them one by one"));
    PackedOutput out(path, PackedOutput::Form::Plain);
    const auto word = [&](std::uint64_t value) {
        const auto word32 = std::uint32_t(value);
        out.write(&word32, sizeof word32);
    };
    const auto list = [&](const auto& values) {
        out.write(values.data(), values.size() * sizeof values[0]);
    };
    constexpr std::uint32_t magic = 0x46546C67; // "glTF"
    constexpr std::uint32_t jsonChunk = 0x4E4F534A;
    constexpr std::uint32_t binaryChunk = 0x004E4942;
    word(magic);
    word(2);
    word(total);
    word(std::uint64_t(json.size()));
    word(jsonChunk);
    out.write(json.constData(), std::size_t(json.size()));
    word(document.size);
    word(binaryChunk);
    for (const MeshPart& part : parts) {
        list(part.vertices);
        list(normalsOf(part));
        list(part.triangles);
    }
    if (const Clause reason = out.close(); !reason.isEmpty())
        return failure(ErrorCode::FileUnwritable, path, reason);
    return {};
}

} // namespace core
