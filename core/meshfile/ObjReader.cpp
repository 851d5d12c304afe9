// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshParts.h"

#include <cmath>

namespace core {

namespace {

class ObjFile {
public:
    /// @return what is wrong with a line; empty: nothing
    Clause take(const QByteArray& line)
    {
        if (line.startsWith('#')) {
            if (m_space.isEmpty())
                m_space = spaceIn(line);
            return {};
        }
        const std::vector<QByteArrayView> words = wordsOf(line);
        if (words.empty())
            return {};
        if (words[0] == "v")
            return takeVertex(words);
        if (words[0] == "f")
            return takeFace(words);
        if (words[0] == "o" || words[0] == "g")
            begin(words[0] == "o", QString::fromUtf8(line.mid(1)).trimmed());
        return {};
    }

    [[nodiscard]] ReadMesh take() &&
    {
        ReadMesh mesh{.space = m_space, .parts = {}};
        if (!m_anyColour)
            m_colours.clear();
        for (Part& part : m_parts) {
            if (part.triangles.empty())
                continue;
            mesh.parts.push_back(
                partWithOwnVertices(m_vertices, m_colours, std::move(part.triangles)));
            mesh.parts.back().name = part.name;
        }
        return mesh;
    }

private:
    struct Part {
        QString name;
        std::vector<glm::uvec3> triangles;
    };

    // Groups divide a file that has no objects.
    void begin(bool isObject, const QString& name)
    {
        if (!isObject && m_hasObjects)
            return;
        m_hasObjects = m_hasObjects || isObject;
        m_parts.push_back({.name = name, .triangles = {}});
    }

    Clause takeVertex(const std::vector<QByteArrayView>& words)
    {
        glm::dvec3 place;
        if (words.size() < 4 || !isNumber(words[1], place.x) || !isNumber(words[2], place.y)
            || !isNumber(words[3], place.z))
            return Clause::saying("a point that lies nowhere");
        m_vertices.emplace_back(place);
        std::uint32_t rgb = 0;
        bool coloured = words.size() >= 7;
        for (std::size_t i = 4; coloured && i < 7; ++i) {
            double share = 0.0;
            coloured = isNumber(words[i], share) && share >= 0.0 && share <= 1.0;
            rgb = (rgb << 8U) | std::uint32_t(coloured ? std::lround(share * 255.0) : 0);
        }
        m_anyColour = m_anyColour || coloured;
        m_colours.push_back(coloured ? rgb : 0);
        return {};
    }

    Clause takeFace(const std::vector<QByteArrayView>& words)
    {
        if (words.size() < 4)
            return Clause::saying("a face of less than three corners");
        if (m_parts.empty())
            m_parts.emplace_back();
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 1; i < words.size(); ++i) {
            // "vertex", "vertex/texture", "vertex/texture/normal"; negative ones count backwards.
            const qsizetype slash = words[i].indexOf('/');
            double number = 0.0;
            if (!isNumber(slash < 0 ? words[i] : words[i].first(slash), number)
                || number != std::floor(number))
                return Clause::saying("a face of points that are not there");
            const double count = double(m_vertices.size());
            const double index = number < 0.0 ? count + number : number - 1.0;
            if (!(index >= 0.0 && index < count))
                return Clause::saying("a face of points that are not there");
            corners.push_back(std::uint32_t(index));
        }
        for (std::size_t i = 2; i < corners.size(); ++i)
            m_parts.back().triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
        return {};
    }

    QString m_space;
    std::vector<glm::vec3> m_vertices;
    std::vector<std::uint32_t> m_colours; ///< one a vertex; 0 where it has none
    bool m_anyColour = false;
    bool m_hasObjects = false;
    std::vector<Part> m_parts;
};

} // namespace

Result<ReadMesh> readObj(const QString& path)
{
    const Result<QByteArray> bytes = meshBytes(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    ObjFile file;
    for (qsizetype at = 0; at < bytes->size();) {
        qsizetype end = bytes->indexOf('\n', at);
        end = end < 0 ? bytes->size() : end;
        if (const Clause wrong = file.take(bytes->mid(at, end - at).trimmed()); !wrong.isEmpty())
            return unreadableMesh(path, wrong);
        at = end + 1;
    }
    ReadMesh mesh = std::move(file).take();
    if (mesh.parts.empty())
        return unreadableMesh(path, Clause::saying("it has no face"));
    return mesh;
}

} // namespace core
