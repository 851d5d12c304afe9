// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshWriter.h"

#include "core/meshfile/MeshNames.h"
#include "core/voxelfile/PackedOutput.h"

#include <QByteArray>

#include <bit>
#include <cstring>
#include <limits>

namespace core {

static_assert(std::endian::native == std::endian::little, "what is written is little endian");

namespace {

constexpr qsizetype bufferSize = 1 << 20;

/// Gathers small pieces on their way to a file.
class MeshOutput {
public:
    explicit MeshOutput(const QString& path)
        : m_path(path)
        , m_output(path, PackedOutput::Form::Plain)
    {
        m_buffer.reserve(bufferSize + 4096);
    }

    MeshOutput& operator<<(const QByteArray& bytes)
    {
        m_buffer += bytes;
        if (m_buffer.size() >= bufferSize)
            flush();
        return *this;
    }
    template <typename T> void put(const T& value)
    {
        m_buffer.append(reinterpret_cast<const char*>(&value), sizeof value);
        if (m_buffer.size() >= bufferSize)
            flush();
    }
    Result<void> close()
    {
        flush();
        if (const Clause reason = m_output.close(); !reason.isEmpty())
            return failure(ErrorCode::FileUnwritable, m_path, reason);
        return {};
    }

private:
    void flush()
    {
        if (!m_buffer.isEmpty())
            m_output.write(m_buffer.constData(), std::size_t(m_buffer.size()));
        m_buffer.resize(0);
    }

    QString m_path;
    PackedOutput m_output;
    QByteArray m_buffer;
};

struct Counts {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};

/// Errors: UnsupportedFormat.
Result<Counts> countsOf(const QString& path, const std::vector<MeshPart>& parts)
{
    Counts counts;
    for (const MeshPart& part : parts) {
        counts.vertices += part.vertices.size();
        counts.triangles += part.triangles.size();
    }
    constexpr auto most = std::size_t(std::numeric_limits<std::int32_t>::max());
    if (counts.vertices > most || counts.triangles > most)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("the surface has more points than the format can count"));
    return counts;
}

/// As short as says the same float again.
QByteArray exactly(float value)
{
    return QByteArray::number(double(value), 'g', 9);
}

QByteArray colourShares(std::uint32_t rgb)
{
    QByteArray text;
    for (const int shift : {16, 8, 0})
        text += ' ' + QByteArray::number(double((rgb >> shift) & 0xffU) / 255.0, 'g', 6);
    return text;
}

} // namespace

QString oneLine(const QString& name)
{
    QString plain = name;
    for (QChar& character : plain) {
        if (character.category() == QChar::Other_Control)
            character = u' ';
    }
    plain = plain.simplified();
    return plain.isEmpty() ? QStringLiteral("Segment") : plain;
}

Result<void> writeStl(const QString& path, const std::vector<MeshPart>& parts, const QString& space)
{
    const auto counts = countsOf(path, parts);
    if (!counts)
        return tl::unexpected(counts.error());
    MeshOutput out(path);
    constexpr qsizetype headerSize = 80;
    // Not "solid", which begins a text.
    out << ("Burin, binary STL in mm, SPACE=" + space.toLatin1())
               .leftJustified(headerSize, ' ', true);
    out.put(std::uint32_t(counts->triangles));
    for (const MeshPart& part : parts) {
        for (const glm::uvec3& triangle : part.triangles) {
            const glm::vec3& a = part.vertices[triangle.x];
            const glm::vec3& b = part.vertices[triangle.y];
            const glm::vec3& c = part.vertices[triangle.z];
            const glm::vec3 cross = glm::cross(b - a, c - a);
            const float length = glm::length(cross);
            out.put(length > 0.0F ? cross / length : glm::vec3(0.0F));
            out.put(a);
            out.put(b);
            out.put(c);
            out.put(std::uint16_t(0));
        }
    }
    return out.close();
}

Result<void> writeObj(const QString& path, const std::vector<MeshPart>& parts, const QString& space)
{
    if (const auto counts = countsOf(path, parts); !counts)
        return tl::unexpected(counts.error());
    MeshOutput out(path);
    out << "# Burin, surfaces in mm\n# SPACE=" + space.toLatin1() + '\n';
    std::size_t first = 1;
    for (const MeshPart& part : parts) {
        out << "o " + oneLine(part.name).toUtf8() + '\n';
        const QByteArray colour = colourShares(part.rgb) + '\n';
        for (const glm::vec3& vertex : part.vertices)
            out << "v " + exactly(vertex.x) + ' ' + exactly(vertex.y) + ' ' + exactly(vertex.z)
                    + colour;
        for (const glm::uvec3& triangle : part.triangles) {
            QByteArray line("f");
            for (int i = 0; i < 3; ++i)
                line += ' ' + QByteArray::number(qulonglong(first + triangle[i]));
            out << line + '\n';
        }
        first += part.vertices.size();
    }
    return out.close();
}

Result<void> writePly(const QString& path, const std::vector<MeshPart>& parts, const QString& space)
{
    const auto counts = countsOf(path, parts);
    if (!counts)
        return tl::unexpected(counts.error());
    MeshOutput out(path);
    out << "ply\nformat binary_little_endian 1.0\ncomment Burin, surfaces in mm\ncomment SPACE="
            + space.toLatin1() + '\n';
    std::size_t face = 0;
    for (const MeshPart& part : parts) {
        out << "comment segment " + QByteArray::number(part.label) + " faces "
                + QByteArray::number(qulonglong(face)) + " to "
                + QByteArray::number(qulonglong(face + part.triangles.size() - 1)) + ": "
                + oneLine(part.name).toUtf8() + '\n';
        face += part.triangles.size();
    }
    out << "element vertex " + QByteArray::number(qulonglong(counts->vertices))
            + "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
              "property uchar green\nproperty uchar blue\nelement face "
            + QByteArray::number(qulonglong(counts->triangles))
            + "\nproperty list uchar int vertex_indices\nproperty uchar label\nend_header\n";
    for (const MeshPart& part : parts) {
        for (const glm::vec3& vertex : part.vertices) {
            out.put(vertex);
            for (const int shift : {16, 8, 0})
                out.put(std::uint8_t((part.rgb >> shift) & 0xffU));
        }
    }
    std::uint32_t first = 0;
    for (const MeshPart& part : parts) {
        for (const glm::uvec3& triangle : part.triangles) {
            out.put(std::uint8_t(3));
            out.put(triangle + first);
            out.put(part.label);
        }
        first += std::uint32_t(part.vertices.size());
    }
    return out.close();
}

} // namespace core
