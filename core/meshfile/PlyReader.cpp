// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshParts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace core {

namespace {

enum class Number { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

std::optional<Number> numberOf(QByteArrayView name)
{
    constexpr struct {
        const char* names[2];
        Number number;
    } known[] = {{{"char", "int8"}, Number::Int8}, {{"uchar", "uint8"}, Number::UInt8},
        {{"short", "int16"}, Number::Int16}, {{"ushort", "uint16"}, Number::UInt16},
        {{"int", "int32"}, Number::Int32}, {{"uint", "uint32"}, Number::UInt32},
        {{"float", "float32"}, Number::Float32}, {{"double", "float64"}, Number::Float64}};
    for (const auto& each : known) {
        if (name == each.names[0] || name == each.names[1])
            return each.number;
    }
    return std::nullopt;
}

struct Property {
    QByteArray name;
    Number number = Number::Float32;
    std::optional<Number> count; ///< of a list
};

struct Element {
    QByteArray name;
    qint64 count = 0;
    std::vector<Property> properties;
};

/// Faces that a comment gives to a segment: "comment segment 3 faces 0 to 99: NAME".
struct SegmentFaces {
    int label = 0;
    qint64 first = 0;
    qint64 last = -1;
    QString name;
};

enum class Form { Text, LittleEndian, BigEndian };

struct Header {
    Form form = Form::Text;
    QString space;
    std::vector<Element> elements;
    std::vector<SegmentFaces> segments;
    qsizetype end = 0;
};

/// The body's numbers, one after the other; `good` is false once there are no more.
class Numbers {
public:
    Numbers(const QByteArray& bytes, qsizetype at, Form form)
        : m_bytes(bytes)
        , m_at(at)
        , m_form(form)
    {
    }

    [[nodiscard]] bool good() const { return m_good; }
    double next(Number number)
    {
        switch (number) {
        case Number::Int8:
            return as<std::int8_t>();
        case Number::UInt8:
            return as<std::uint8_t>();
        case Number::Int16:
            return as<std::int16_t>();
        case Number::UInt16:
            return as<std::uint16_t>();
        case Number::Int32:
            return as<std::int32_t>();
        case Number::UInt32:
            return as<std::uint32_t>();
        case Number::Float32:
            return as<float>();
        case Number::Float64:
            break;
        }
        return as<double>();
    }

private:
    template <class T> double as()
    {
        if (m_form == Form::Text)
            return word();
        if (!m_good || m_bytes.size() - m_at < qsizetype(sizeof(T))) {
            m_good = false;
            return 0.0;
        }
        char cells[sizeof(T)];
        std::memcpy(cells, m_bytes.constData() + m_at, sizeof(T));
        if (m_form == Form::BigEndian)
            std::reverse(cells, cells + sizeof(T));
        m_at += qsizetype(sizeof(T));
        T value;
        std::memcpy(&value, cells, sizeof(T));
        return double(value);
    }
    double word()
    {
        const auto isBlank = [](char character) { return std::strchr(" \t\r\n", character); };
        while (m_at < m_bytes.size() && isBlank(m_bytes[m_at]))
            ++m_at;
        qsizetype end = m_at;
        while (end < m_bytes.size() && !isBlank(m_bytes[end]))
            ++end;
        double value = 0.0;
        m_good = m_good && isNumber(QByteArrayView(m_bytes).sliced(m_at, end - m_at), value);
        m_at = end;
        return value;
    }

    const QByteArray& m_bytes;
    qsizetype m_at;
    Form m_form;
    bool m_good = true;
};

Clause takeLine(Header& header, const QByteArray& line)
{
    const std::vector<QByteArrayView> words = wordsOf(line);
    if (words.empty() || words[0] == "ply" || words[0] == "obj_info")
        return {};
    if (words[0] == "format" && words.size() > 1) {
        header.form = words[1] == "binary_little_endian" ? Form::LittleEndian
            : words[1] == "binary_big_endian"            ? Form::BigEndian
                                                         : Form::Text;
    } else if (words[0] == "comment") {
        if (header.space.isEmpty())
            header.space = spaceIn(line);
        if (words.size() > 7 && words[1] == "segment" && words[3] == "faces")
            header.segments.push_back({.label = words[2].toInt(),
                .first = words[4].toLongLong(),
                .last = words[6].chopped(1).toLongLong(),
                .name = QString::fromUtf8(line.mid(line.indexOf(": ") + 2))});
    } else if (words[0] == "element") {
        bool isCount = false;
        const qint64 count = words.size() == 3 ? words[2].toLongLong(&isCount) : 0;
        if (!isCount || count < 0 || count > mostMeshBytes)
            return Clause::saying("an element without a number");
        header.elements.push_back(
            {.name = words[1].toByteArray(), .count = count, .properties = {}});
    } else if (words[0] == "property" && !header.elements.empty()) {
        const bool isList = words.size() == 5 && words[1] == "list";
        if (!isList && words.size() != 3)
            return Clause::saying("a property of no known kind");
        const auto number = numberOf(words[isList ? 3 : 1]);
        const auto count = isList ? numberOf(words[2]) : std::nullopt;
        if (!number || (isList && !count))
            return Clause::saying("a property of no known kind");
        header.elements.back().properties.push_back(
            {.name = words.back().toByteArray(), .number = *number, .count = count});
    }
    return {};
}

Result<Header> headerOf(const QByteArray& bytes, const QString& path)
{
    if (!bytes.startsWith("ply"))
        return unreadableMesh(path, Clause::saying("no PLY"));
    Header header;
    for (qsizetype at = 0;;) {
        const qsizetype end = bytes.indexOf('\n', at);
        if (end < 0)
            return failure(
                ErrorCode::FileTruncated, path, Clause::saying("it ends inside its header"));
        const QByteArray line = bytes.mid(at, end - at).trimmed();
        at = end + 1;
        if (line == "end_header") {
            header.end = at;
            return header;
        }
        if (const Clause wrong = takeLine(header, line); !wrong.isEmpty())
            return unreadableMesh(path, wrong);
    }
}

struct Body {
    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> colours; ///< one a vertex, or none at all
    std::vector<glm::uvec3> triangles;
    std::vector<qint64> faceOf; ///< by triangle
    std::vector<int> labels; ///< by face; empty: the file has none
};

Clause readVertices(const Element& element, Numbers& numbers, Body& body)
{
    const auto has = [&element](const char* name) {
        return std::any_of(element.properties.begin(), element.properties.end(),
            [name](const Property& property) { return property.name == name && !property.count; });
    };
    if (!has("x") || !has("y") || !has("z"))
        return Clause::saying("points without a place");
    const bool coloured = has("red") && has("green") && has("blue");
    for (qint64 i = 0; i < element.count && numbers.good(); ++i) {
        glm::dvec3 place(0.0);
        glm::dvec3 colour(0.0);
        for (const Property& property : element.properties) {
            if (property.count) {
                for (double left = numbers.next(*property.count); left > 0.0 && numbers.good();
                     --left)
                    numbers.next(property.number);
                continue;
            }
            const double value = numbers.next(property.number);
            constexpr const char* names[] = {"x", "y", "z", "red", "green", "blue"};
            for (int k = 0; k < 6; ++k) {
                if (property.name == names[k])
                    (k < 3 ? place[k] : colour[k - 3]) =
                        k >= 3 && property.number == Number::Float32 ? value * 255.0 : value;
            }
        }
        if (!(std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z)))
            return Clause::saying("a point that lies nowhere");
        body.vertices.emplace_back(place);
        std::uint32_t rgb = 0;
        for (int channel = 0; channel < 3; ++channel)
            rgb = (rgb << 8U) | std::uint32_t(std::clamp(std::round(colour[channel]), 0.0, 255.0));
        if (coloured)
            body.colours.push_back(rgb);
    }
    return {};
}

Clause readFaces(const Element& element, Numbers& numbers, Body& body)
{
    for (qint64 face = 0; face < element.count && numbers.good(); ++face) {
        for (const Property& property : element.properties) {
            if (!property.count) {
                const double value = numbers.next(property.number);
                if (property.name == "label")
                    body.labels.push_back(int(std::clamp(value, -1.0, 65536.0)));
                continue;
            }
            const bool isFace =
                property.name == "vertex_indices" || property.name == "vertex_index";
            const double corners = numbers.next(*property.count);
            std::uint32_t first = 0;
            std::uint32_t before = 0;
            for (double corner = 0.0; corner < corners && numbers.good(); ++corner) {
                const double index = numbers.next(property.number);
                if (!isFace)
                    continue;
                if (!(index >= 0.0 && index < double(body.vertices.size())))
                    return Clause::saying("a face of points that are not there");
                const auto number = std::uint32_t(index);
                if (corner == 0.0)
                    first = number;
                if (corner >= 2.0) {
                    body.triangles.emplace_back(first, before, number);
                    body.faceOf.push_back(face);
                }
                before = number;
            }
        }
    }
    return {};
}

Clause readBody(const Header& header, Numbers& numbers, Body& body)
{
    for (const Element& element : header.elements) {
        Clause wrong;
        if (element.name == "vertex") {
            wrong = readVertices(element, numbers, body);
        } else if (element.name == "face") {
            wrong = readFaces(element, numbers, body);
        } else {
            Body passedOver;
            wrong = readFaces(element, numbers, passedOver);
        }
        if (!wrong.isEmpty())
            return wrong;
    }
    return {};
}

/// Parts as the comments say, if they say it of all faces; else one.
Result<std::vector<ReadMeshPart>> partsOf(const Header& header, Body& body, const QString& path)
{
    std::vector<ReadMeshPart> parts;
    if (header.segments.empty()) {
        parts.push_back(
            partWithOwnVertices(body.vertices, body.colours, std::move(body.triangles)));
        return parts;
    }
    const auto faces = std::find_if(header.elements.begin(), header.elements.end(),
        [](const Element& element) { return element.name == "face"; });
    std::size_t next = 0;
    qint64 face = 0;
    for (const SegmentFaces& segment : header.segments) {
        if (segment.first != face || faces == header.elements.end() || segment.last >= faces->count)
            return unreadableMesh(path, Clause::saying("faces that belong to no segment"));
        std::vector<glm::uvec3> own;
        for (; next < body.triangles.size() && body.faceOf[next] <= segment.last; ++next)
            own.push_back(body.triangles[next]);
        for (; face <= segment.last; ++face) {
            if (std::size_t(face) < body.labels.size()
                && body.labels[std::size_t(face)] != segment.label)
                return unreadableMesh(path, Clause::saying("a face of another segment"));
        }
        parts.push_back(partWithOwnVertices(body.vertices, body.colours, std::move(own)));
        parts.back().label = segment.label;
        parts.back().name = segment.name;
    }
    if (next != body.triangles.size())
        return unreadableMesh(path, Clause::saying("faces that belong to no segment"));
    return parts;
}

} // namespace

Result<ReadMesh> readPly(const QString& path)
{
    const Result<QByteArray> bytes = meshBytes(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const Result<Header> header = headerOf(*bytes, path);
    if (!header)
        return tl::unexpected(header.error());
    Numbers numbers(*bytes, header->end, header->form);
    Body body;
    if (const Clause wrong = readBody(*header, numbers, body); !wrong.isEmpty())
        return unreadableMesh(path, wrong);
    if (!numbers.good())
        return failure(ErrorCode::FileTruncated, path,
            Clause::saying("not as many points and faces as it says"));
    Result<std::vector<ReadMeshPart>> parts = partsOf(*header, body, path);
    if (!parts)
        return tl::unexpected(parts.error());
    return ReadMesh{.space = header->space, .parts = *std::move(parts)};
}

} // namespace core
