// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceDelta.h"

#include "core/base/Sha256.h"

#include <QtEndian>

#include <bit>
#include <cmath>
#include <cstring>

namespace core {

namespace {

constexpr char magic[] = "MDL1";
constexpr std::size_t magicBytes = 4;
constexpr std::size_t vertexBytes = 49;
/// Of a change, with one side.
constexpr std::size_t leastVertexChange = 5 + vertexBytes;
/// Of a change, with one ring of three.
constexpr std::size_t leastFaceChange = 12 + 12;
enum Sides : std::uint8_t { Before = 1, After = 2 };

using VertexBytes = std::array<std::uint8_t, vertexBytes>;

VertexBytes bytesOf(const SimplexVertex& vertex)
{
    VertexBytes bytes{};
    std::uint8_t* to = bytes.data();
    for (int axis = 0; axis < 3; ++axis, to += 8)
        qToLittleEndian(std::bit_cast<std::uint64_t>(vertex.positionLps[axis]), to);
    for (const auto& ids : {vertex.neighbours, vertex.faces}) {
        for (const std::uint32_t id : ids) {
            qToLittleEndian(id, to);
            to += 4;
        }
    }
    *to = std::uint8_t(vertex.mark);
    return bytes;
}

/// None: no vertex is like that.
std::optional<SimplexVertex> vertexOf(const VertexBytes& bytes)
{
    SimplexVertex vertex;
    const std::uint8_t* from = bytes.data();
    for (int axis = 0; axis < 3; ++axis, from += 8) {
        vertex.positionLps[axis] = std::bit_cast<double>(qFromLittleEndian<std::uint64_t>(from));
        if (!std::isfinite(vertex.positionLps[axis]))
            return std::nullopt;
    }
    for (auto* ids : {&vertex.neighbours, &vertex.faces}) {
        for (std::uint32_t& id : *ids) {
            id = qFromLittleEndian<std::uint32_t>(from);
            from += 4;
            if (id >= mostPackedIds)
                return std::nullopt;
        }
    }
    if (*from > std::uint8_t(SurfaceMark::Red))
        return std::nullopt;
    vertex.mark = SurfaceMark(*from);
    return vertex;
}

VertexBytes differenceOf(VertexBytes one, const VertexBytes& other)
{
    for (std::size_t i = 0; i < one.size(); ++i)
        one[i] = std::uint8_t(one[i] ^ other[i]);
    return one;
}

class Writer {
public:
    explicit Writer(std::size_t bytes) { m_bytes.reserve(qsizetype(bytes)); }
    void add(const void* data, std::size_t size)
    {
        m_bytes.append(static_cast<const char*>(data), qsizetype(size));
    }
    void add(std::uint8_t value) { add(&value, 1); }
    void add(std::uint32_t value)
    {
        value = qToLittleEndian(value);
        add(&value, sizeof value);
    }
    void add(const VertexBytes& bytes) { add(bytes.data(), bytes.size()); }
    void add(const FaceRing& ring)
    {
        for (const VertexId id : ring)
            add(id);
    }
    [[nodiscard]] QByteArray take() { return std::move(m_bytes); }

private:
    QByteArray m_bytes;
};

/// Gives zeros where nothing is left, and knows that it did.
class Reader {
public:
    explicit Reader(const QByteArray& bytes)
        : m_bytes(bytes)
    {
    }
    void take(void* data, std::size_t size)
    {
        if (size > left()) {
            m_isShort = true;
            std::memset(data, 0, size);
            return;
        }
        std::memcpy(data, m_bytes.constData() + m_at, size);
        m_at += size;
    }
    template <typename Number> Number number()
    {
        Number value{};
        take(&value, sizeof value);
        return qFromLittleEndian(value);
    }
    VertexBytes vertex()
    {
        VertexBytes bytes{};
        take(bytes.data(), bytes.size());
        return bytes;
    }
    [[nodiscard]] std::size_t left() const { return std::size_t(m_bytes.size()) - m_at; }
    [[nodiscard]] bool isShort() const { return m_isShort; }

private:
    const QByteArray& m_bytes;
    std::size_t m_at = 0;
    bool m_isShort = false;
};

bool readVertex(Reader& reader, SimplexMeshDelta::VertexChange& change)
{
    change.id = reader.number<std::uint32_t>();
    const auto sides = reader.number<std::uint8_t>();
    if (change.id >= mostPackedIds || sides == 0 || sides > (Before | After))
        return false;
    VertexBytes before{};
    if ((sides & Before) != 0) {
        before = reader.vertex();
        change.before = vertexOf(before);
        if (!change.before)
            return false;
    }
    if ((sides & After) != 0) {
        change.after = vertexOf(differenceOf(reader.vertex(), before));
        if (!change.after)
            return false;
    }
    return !reader.isShort();
}

bool readRing(Reader& reader, std::uint32_t count, FaceRing& ring)
{
    if (count == 0)
        return true;
    if (count < 3 || count > reader.left() / 4)
        return false;
    ring.resize(count);
    for (VertexId& id : ring) {
        id = reader.number<std::uint32_t>();
        if (id >= mostPackedIds)
            return false;
    }
    return true;
}

bool readFace(Reader& reader, SimplexMeshDelta::FaceChange& change)
{
    change.id = reader.number<std::uint32_t>();
    const auto before = reader.number<std::uint32_t>();
    const auto after = reader.number<std::uint32_t>();
    return change.id < mostPackedIds && (before != 0 || after != 0)
        && readRing(reader, before, change.before) && readRing(reader, after, change.after)
        && !reader.isShort();
}

/// Reads so many changes, ids ascending.
template <typename Changes, typename Read>
bool readChanges(Reader& reader, std::uint32_t count, Changes& changes, const Read& read)
{
    changes.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t last = i == 0 ? 0 : changes.back().id;
        auto& change = changes.emplace_back();
        if (!read(reader, change) || (i > 0 && change.id <= last))
            return false;
    }
    return true;
}

/// Whether @p mesh has of all that changed what @p side says.
template <typename VertexSide, typename FaceSide>
bool isAt(const SimplexMeshDelta& delta, const SimplexMesh& mesh, const VertexSide& vertexSide,
    const FaceSide& faceSide)
{
    for (const auto& change : delta.vertices) {
        const std::optional<SimplexVertex>& here = vertexSide(change);
        if (mesh.hasVertex(change.id) != here.has_value()
            || (here && !identical(mesh.vertex(change.id), *here)))
            return false;
    }
    for (const auto& change : delta.faces) {
        const FaceRing& here = faceSide(change);
        const bool exists = mesh.hasFace(change.id);
        if (exists == here.empty() || (exists && mesh.ring(change.id) != here))
            return false;
    }
    return true;
}

} // namespace

QByteArray packed(const SimplexMeshDelta& delta)
{
    std::size_t size = magicBytes + 8 + delta.vertices.size() * (5 + 2 * vertexBytes);
    for (const auto& change : delta.faces)
        size += 12 + 4 * (change.before.size() + change.after.size());
    Writer writer(size);
    writer.add(magic, magicBytes);
    writer.add(std::uint32_t(delta.vertices.size()));
    writer.add(std::uint32_t(delta.faces.size()));
    for (const auto& change : delta.vertices) {
        writer.add(change.id);
        writer.add(std::uint8_t((change.before ? Before : 0) | (change.after ? After : 0)));
        VertexBytes before{};
        if (change.before) {
            before = bytesOf(*change.before);
            writer.add(before);
        }
        if (change.after)
            writer.add(differenceOf(bytesOf(*change.after), before));
    }
    for (const auto& change : delta.faces) {
        writer.add(change.id);
        writer.add(std::uint32_t(change.before.size()));
        writer.add(std::uint32_t(change.after.size()));
        writer.add(change.before);
        writer.add(change.after);
    }
    return writer.take();
}

Result<SimplexMeshDelta> unpackedSurfaceDelta(const QByteArray& bytes)
{
    const auto damaged = [](const Clause& why) {
        return failure(ErrorCode::SessionDamaged, QString(), why);
    };
    if (!bytes.startsWith(magic))
        return damaged(Clause::saying("this is no difference of a surface"));
    Reader reader(bytes);
    std::array<char, magicBytes> read{};
    reader.take(read.data(), read.size());
    const auto vertices = reader.number<std::uint32_t>();
    const auto faces = reader.number<std::uint32_t>();
    if (reader.isShort() || vertices > reader.left() / leastVertexChange
        || faces > (reader.left() - vertices * leastVertexChange) / leastFaceChange)
        return damaged(Clause::saying("the difference of the surface ends early"));
    SimplexMeshDelta delta;
    if (!readChanges(reader, vertices, delta.vertices, readVertex))
        return damaged(Clause::saying("a vertex of the surface is not as it can be"));
    if (!readChanges(reader, faces, delta.faces, readFace))
        return damaged(Clause::saying("a face of the surface is not as it can be"));
    if (reader.left() != 0)
        return damaged(Clause::saying("something follows the difference of the surface"));
    return delta;
}

bool canRedo(const SimplexMeshDelta& delta, const SimplexMesh& mesh)
{
    return isAt(
        delta, mesh, [](const auto& change) -> const auto& { return change.before; },
        [](const auto& change) -> const auto& { return change.before; });
}

bool canUndo(const SimplexMeshDelta& delta, const SimplexMesh& mesh)
{
    return isAt(
        delta, mesh, [](const auto& change) -> const auto& { return change.after; },
        [](const auto& change) -> const auto& { return change.after; });
}

SimplexMeshDelta deltaFromNothing(const SimplexMesh& mesh)
{
    SimplexMeshDelta delta;
    delta.vertices.reserve(mesh.vertexCount());
    for (const VertexId id : mesh.vertexIds())
        delta.vertices.push_back({.id = id, .before = std::nullopt, .after = mesh.vertex(id)});
    delta.faces.reserve(mesh.faceCount());
    for (const FaceId id : mesh.faceIds())
        delta.faces.push_back({.id = id, .before = {}, .after = mesh.ring(id)});
    return delta;
}

QByteArray sha256Of(const SimplexMesh& mesh)
{
    Sha256 sum;
    const auto add = [&](Writer& writer) { sum.add(writer.take()); };
    Writer head(8);
    head.add(std::uint32_t(mesh.vertexCount()));
    head.add(std::uint32_t(mesh.faceCount()));
    add(head);
    for (VertexId id = 0; id < mesh.vertexSlots(); ++id) {
        if (!mesh.hasVertex(id))
            continue;
        Writer one(4 + vertexBytes);
        one.add(id);
        one.add(bytesOf(mesh.vertex(id)));
        add(one);
    }
    for (FaceId id = 0; id < mesh.faceSlots(); ++id) {
        if (!mesh.hasFace(id))
            continue;
        const FaceRing& ring = mesh.ring(id);
        Writer one(8 + 4 * ring.size());
        one.add(id);
        one.add(std::uint32_t(ring.size()));
        one.add(ring);
        add(one);
    }
    return sum.takeHex();
}

} // namespace core
