// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshReader.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <cstring>

namespace core {

namespace {

/// A byte of sRGB for a share of light (IEC 61966-2-1).
std::uint32_t encoded(double light)
{
    const double share =
        light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
    return std::uint32_t(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

struct Document {
    QJsonObject json;
    QByteArray buffer;

    [[nodiscard]] QJsonObject entry(const char* list, const QJsonValue& index) const
    {
        return json[QLatin1String(list)].toArray()[index.toInt(-1)].toObject();
    }
    /// The values of an accessor of @p component numbers of four bytes each.
    template <typename T>
    [[nodiscard]] bool read(
        const QJsonValue& index, int component, std::vector<T>& values, std::size_t numbers) const
    {
        const QJsonObject accessor = entry("accessors", index);
        const QJsonObject view = entry("bufferViews", accessor[QStringLiteral("bufferView")]);
        const auto at = qsizetype(view[QStringLiteral("byteOffset")].toDouble());
        const auto size = qsizetype(view[QStringLiteral("byteLength")].toDouble());
        const auto count = std::size_t(accessor[QStringLiteral("count")].toDouble());
        const std::size_t each = sizeof(T) / (4 * numbers);
        if (accessor[QStringLiteral("componentType")].toInt() != component || at < 0 || size < 0
            || at % 4 != 0 || at + size > buffer.size() || std::size_t(size) != count * numbers * 4
            || count % each != 0)
            return false;
        values.resize(count / each);
        std::memcpy(values.data(), buffer.constData() + at, std::size_t(size));
        return true;
    }
};

/// Superior must be up, and a millimetre one.
bool standsUpright(const QJsonArray& matrix, const QString& space)
{
    const double sign = space == QLatin1String("LPS") ? 1.0 : -1.0;
    const double expected[16] = {
        0.001 * sign, 0, 0, 0, 0, 0, -0.001 * sign, 0, 0, 0.001, 0, 0, 0, 0, 0, 1};
    for (int i = 0; i < 16; ++i) {
        if (matrix[i].toDouble(NAN) != expected[i])
            return false;
    }
    return true;
}

} // namespace

Result<ReadMesh> readGltf(const QString& path)
{
    const auto unreadable = [&](const Clause& reason) {
        return failure(ErrorCode::FileUnreadable, path, reason);
    };
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    const QByteArray bytes = file.readAll();
    const auto word = [&](qsizetype at) {
        std::uint32_t value = 0;
        if (at + 4 <= bytes.size())
            std::memcpy(&value, bytes.constData() + at, 4);
        return qsizetype(value);
    };
    if (!bytes.startsWith("glTF") || word(4) != 2 || word(8) != bytes.size()
        || bytes.mid(16, 4) != "JSON" || bytes.mid(24 + word(12), 4) != QByteArray("BIN\0", 4)
        || 28 + word(12) + word(20 + word(12)) != bytes.size())
        return unreadable(Clause::saying("no binary glTF 2.0"));
    Document document;
    document.json = QJsonDocument::fromJson(bytes.mid(20, word(12))).object();
    document.buffer = bytes.mid(28 + word(12));
    ReadMesh mesh;
    mesh.space =
        document.json[QStringLiteral("asset")][QStringLiteral("extras")][QStringLiteral("space")]
            .toString();
    const QJsonObject root = document.entry("nodes", 0);
    if (!standsUpright(root[QStringLiteral("matrix")].toArray(), mesh.space))
        return unreadable(Clause::saying("it does not stand upright"));
    const QJsonArray children = root[QStringLiteral("children")].toArray();
    for (const QJsonValue& child : children) {
        const QJsonObject node = document.entry("nodes", child);
        const QJsonObject primitive =
            document.entry("meshes", node[QStringLiteral("mesh")])[QStringLiteral("primitives")][0]
                .toObject();
        const QJsonArray colour =
            document
                .entry("materials", primitive[QStringLiteral("material")])[QStringLiteral(
                    "pbrMetallicRoughness")][QStringLiteral("baseColorFactor")]
                .toArray();
        ReadMeshPart part;
        part.name = node[QStringLiteral("name")].toString();
        part.label = node[QStringLiteral("extras")][QStringLiteral("label")].toInt(-1);
        std::uint32_t rgb = 0;
        for (int i = 0; i < 3; ++i)
            rgb = (rgb << 8U) | encoded(colour[i].toDouble());
        part.rgb = rgb;
        constexpr int floats = 5126;
        constexpr int unsignedInts = 5125;
        if (!document.read(primitive[QStringLiteral("attributes")][QStringLiteral("POSITION")],
                floats, part.vertices, 3)
            || !document.read(
                primitive[QStringLiteral("indices")], unsignedInts, part.triangles, 1))
            return unreadable(Clause::saying("points or faces are not where they should be"));
        for (const glm::uvec3& triangle : part.triangles) {
            for (int i = 0; i < 3; ++i) {
                if (triangle[i] >= part.vertices.size())
                    return unreadable(Clause::saying("a face of points that are not there"));
            }
        }
        mesh.parts.push_back(std::move(part));
    }
    return mesh;
}

} // namespace core
