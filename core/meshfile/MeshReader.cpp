// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshReader.h"

#include <QFile>

#include <charconv>
#include <cmath>
#include <cstring>

namespace core {

namespace {

tl::unexpected<Error> unreadable(const QString& path, const char* reason)
{
    return failure(ErrorCode::FileUnreadable, path, QString(QLatin1String(reason)));
}

Result<QByteArray> bytesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    return file.readAll();
}

template <typename T> T valueAt(const QByteArray& bytes, qsizetype at)
{
    T value{};
    std::memcpy(&value, bytes.constData() + at, sizeof value);
    return value;
}

/// "… SPACE=LPS …"
QString spaceIn(const QByteArray& text)
{
    const qsizetype at = text.indexOf("SPACE=");
    return at < 0 ? QString() : QString::fromLatin1(text.mid(at + 6, 3));
}

bool indicesAreThere(const ReadMeshPart& part)
{
    for (const glm::uvec3& triangle : part.triangles) {
        for (int i = 0; i < 3; ++i) {
            if (triangle[i] >= part.vertices.size())
                return false;
        }
    }
    return true;
}

/// Numbers of a line, apart by blanks; empty if there is anything else.
std::vector<double> numbersIn(const QByteArray& line)
{
    std::vector<double> numbers;
    const char* at = line.constData();
    const char* end = at + line.size();
    while (at < end) {
        if (*at == ' ') {
            ++at;
            continue;
        }
        double value = 0.0;
        const auto parsed = std::from_chars(at, end, value);
        if (parsed.ec != std::errc() || !std::isfinite(value))
            return {};
        numbers.push_back(value);
        at = parsed.ptr;
    }
    return numbers;
}

} // namespace

Result<ReadMesh> readStl(const QString& path)
{
    const auto bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    constexpr qsizetype header = 84;
    constexpr qsizetype record = 50;
    if (bytes->size() < header || bytes->startsWith("solid"))
        return unreadable(path, "no binary STL");
    const auto count = qsizetype(valueAt<std::uint32_t>(*bytes, 80));
    if (bytes->size() != header + record * count)
        return unreadable(path, "not as many triangles as it says");
    ReadMesh mesh{.space = spaceIn(bytes->left(80)), .parts = std::vector<ReadMeshPart>(1)};
    ReadMeshPart& part = mesh.parts.front();
    for (qsizetype i = 0; i < count; ++i) {
        const auto first = std::uint32_t(part.vertices.size());
        for (int corner = 0; corner < 3; ++corner)
            part.vertices.push_back(
                valueAt<glm::vec3>(*bytes, header + record * i + 12 * (corner + 1)));
        part.triangles.emplace_back(first, first + 1, first + 2);
    }
    return mesh;
}

Result<ReadMesh> readObj(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::FileUnreadable, path, file.errorString());
    ReadMesh mesh;
    std::size_t before = 0;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine().trimmed();
        const QByteArray rest = line.mid(2);
        if (line.startsWith('#')) {
            mesh.space = mesh.space.isEmpty() ? spaceIn(line) : mesh.space;
        } else if (line.startsWith("o ")) {
            before += mesh.parts.empty() ? 0 : mesh.parts.back().vertices.size();
            mesh.parts.emplace_back();
            mesh.parts.back().name = QString::fromUtf8(rest);
        } else if (mesh.parts.empty()) {
            return unreadable(path, "something before the first object");
        } else if (line.startsWith("v ")) {
            ReadMeshPart& part = mesh.parts.back();
            const std::vector<double> numbers = numbersIn(rest);
            if (numbers.size() != 6)
                return unreadable(path, "a vertex without place and colour");
            part.vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
            std::uint32_t rgb = 0;
            for (std::size_t i = 3; i < 6; ++i)
                rgb = (rgb << 8U) | std::uint32_t(std::lround(numbers[i] * 255.0));
            if (part.rgb.value_or(rgb) != rgb)
                return unreadable(path, "an object of two colours");
            part.rgb = rgb;
        } else if (line.startsWith("f ")) {
            const std::vector<double> numbers = numbersIn(rest);
            glm::uvec3 triangle;
            if (numbers.size() != 3)
                return unreadable(path, "a face that is no triangle");
            for (int i = 0; i < 3; ++i) {
                const double index = numbers[std::size_t(i)] - 1.0 - double(before);
                if (!(index >= 0.0 && index < 4.0e9) || index != std::floor(index))
                    return unreadable(path, "a face of points that are not there");
                triangle[i] = std::uint32_t(index);
            }
            mesh.parts.back().triangles.push_back(triangle);
        } else if (!line.isEmpty()) {
            return unreadable(path, "an unknown line");
        }
    }
    for (const ReadMeshPart& part : mesh.parts) {
        if (!indicesAreThere(part))
            return unreadable(path, "a face of points that are not there");
    }
    return mesh;
}

Result<ReadMesh> readPly(const QString& path)
{
    const auto bytes = bytesOf(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const QByteArray endMark("end_header\n");
    const qsizetype headerEnd = bytes->indexOf(endMark);
    if (!bytes->startsWith("ply\nformat binary_little_endian 1.0\n") || headerEnd < 0)
        return unreadable(path, "no binary PLY");
    ReadMesh mesh;
    struct Range {
        qsizetype first = 0;
        qsizetype last = -1;
    };
    std::vector<Range> ranges;
    qsizetype vertices = 0;
    qsizetype faces = 0;
    QByteArray properties;
    for (const QByteArray& line : bytes->left(headerEnd).split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (line.startsWith("comment SPACE="))
            mesh.space = spaceIn(line);
        else if (line.startsWith("comment segment ") && words.size() > 7) {
            mesh.parts.emplace_back();
            mesh.parts.back().label = words[2].toInt();
            mesh.parts.back().name = QString::fromUtf8(line.mid(line.indexOf(": ") + 2));
            ranges.push_back({words[4].toLongLong(), words[6].chopped(1).toLongLong()});
        } else if (line.startsWith("element vertex "))
            vertices = words[2].toLongLong();
        else if (line.startsWith("element face "))
            faces = words[2].toLongLong();
        else if (line.startsWith("property "))
            properties += line.mid(9) + ';';
    }
    if (properties
        != "float x;float y;float z;uchar red;uchar green;uchar blue;list uchar int "
           "vertex_indices;uchar label;")
        return unreadable(path, "other properties");
    constexpr qsizetype vertexSize = 15;
    constexpr qsizetype faceSize = 14;
    const qsizetype firstVertex = headerEnd + endMark.size();
    const qsizetype firstFace = firstVertex + vertexSize * vertices;
    if (vertices < 0 || faces < 0 || bytes->size() != firstFace + faceSize * faces)
        return unreadable(path, "not as many points and faces as it says");
    qsizetype next = 0;
    std::uint32_t base = 0;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        ReadMeshPart& part = mesh.parts[i];
        if (ranges[i].first != next || ranges[i].last >= faces)
            return unreadable(path, "faces that belong to no segment");
        std::uint32_t greatest = base;
        for (; next <= ranges[i].last; ++next) {
            const qsizetype at = firstFace + faceSize * next;
            if (bytes->at(at) != 3 || int(std::uint8_t(bytes->at(at + 13))) != part.label)
                return unreadable(path, "a face that is no triangle of its segment");
            const auto triangle = valueAt<glm::uvec3>(*bytes, at + 1);
            for (int corner = 0; corner < 3; ++corner) {
                if (triangle[corner] < base || qsizetype(triangle[corner]) >= vertices)
                    return unreadable(path, "a face of points that are not there");
                greatest = std::max(greatest, triangle[corner]);
            }
            part.triangles.push_back(triangle - base);
        }
        for (std::uint32_t vertex = base; vertex <= greatest; ++vertex) {
            const qsizetype at = firstVertex + vertexSize * qsizetype(vertex);
            part.vertices.push_back(valueAt<glm::vec3>(*bytes, at));
            std::uint32_t rgb = 0;
            for (int channel = 0; channel < 3; ++channel)
                rgb = (rgb << 8U) | std::uint8_t(bytes->at(at + 12 + channel));
            if (part.rgb.value_or(rgb) != rgb)
                return unreadable(path, "a segment of two colours");
            part.rgb = rgb;
        }
        base = greatest + 1;
    }
    if (next != faces || qsizetype(base) != vertices)
        return unreadable(path, "points or faces that belong to no segment");
    return mesh;
}

} // namespace core
