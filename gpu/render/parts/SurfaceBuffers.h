// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/mesh/SurfaceUpdate.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/VertexArray.h"
#include "gpu/scene/WorldBox.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gpu {

/// The surface that is being refined, as vertex and element buffers (seed B §5.3). Each face is a
/// fan of triangles around its middle. After a change only the vertices and triangles that changed
/// are sent. At every vertex begins one triangle of each of its three faces; these triangles have a
/// fixed place in the element buffer, so changes of the mesh structure move nothing else. Engine
/// thread.
class SurfaceBuffers {
public:
    /// A vertex as the shaders read it.
    struct Vertex {
        glm::vec3 positionLps{0.0f};
        std::uint32_t normalLps = 0; ///< three signed components of ten bits each
        /// Weights of the marks yellow, green and red; the last byte is 255 for the middle of a
        /// face, else 0.
        std::array<std::uint8_t, 4> marks{};
    };
    static_assert(sizeof(Vertex) == 20);

    /// Takes an update without sending it to the GPU. Ids that no mesh has are ignored.
    void apply(const core::SurfaceUpdate& update);
    /// Sends what has changed since the last upload to the GPU.
    void upload();

    /// How much was sent since the beginning.
    struct Counters {
        std::int64_t uploads = 0; ///< uploads that sent anything
        std::int64_t bytes = 0;
    };
    [[nodiscard]] const Counters& counters() const { return m_counters; }

    [[nodiscard]] bool empty() const { return m_faceCount == 0; }
    /// Changes with every update.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// The bounding box of all vertices that were sent.
    [[nodiscard]] const WorldBox& bounds() const { return m_bounds; }
    /// The box in which the surface was or is different since the last call.
    [[nodiscard]] WorldBox takeChanged();

    /// The content by id, for contours. The middles are those of the last upload.
    [[nodiscard]] std::span<const glm::dvec3> positionsLps() const { return m_positions; }
    [[nodiscard]] std::span<const core::SurfaceMark> marks() const { return m_marks; }
    [[nodiscard]] std::span<const core::FaceRing> rings() const { return m_rings; }
    [[nodiscard]] std::span<const glm::dvec3> middlesLps() const { return m_middles; }

    /// Draws all triangles with the program in use; attributes 0 … 2 are those of Vertex.
    void draw() const;

private:
    /// The triangle (vertex, next vertex on the ring, middle of the face).
    struct Corner {
        core::FaceId face = core::noId;
        core::VertexId next = core::noId;
    };
    using Corners = std::array<Corner, 3>;
    using Elements = std::array<std::uint32_t, 9>;

    /// A set of changed ids.
    class Dirty {
    public:
        void add(std::uint32_t id);
        void addAll(std::size_t count);
        [[nodiscard]] bool empty() const { return m_ids.empty(); }
        /// Calls @p run for ascending runs of ids, which may include small gaps, and clears the
        /// set.
        template <class Run> void takeRuns(Run run);

    private:
        std::vector<std::uint32_t> m_ids;
        std::vector<bool> m_has;
    };

    void clear();
    void putVertex(const core::SurfaceUpdate::Vertex& vertex);
    void takeFace(core::FaceId face);
    void putFace(core::FaceId face, const core::FaceRing& ring);
    void noteChanged(const core::FaceRing& ring);
    void makeRoom();
    void placeMiddle(core::FaceId face);
    [[nodiscard]] Vertex vertexOf(core::VertexId id) const;
    [[nodiscard]] Vertex middleOf(core::FaceId face) const;
    [[nodiscard]] Elements elementsOf(core::VertexId id) const;
    void findBounds();

    // By vertex id.
    std::vector<glm::dvec3> m_positions;
    std::vector<glm::vec3> m_normals;
    std::vector<core::SurfaceMark> m_marks;
    std::vector<Corners> m_corners;
    // By face id.
    std::vector<core::FaceRing> m_rings;
    std::vector<glm::dvec3> m_middles;
    std::size_t m_faceCount = 0;

    Dirty m_dirtyVertices;
    Dirty m_dirtyCorners;
    Dirty m_dirtyFaces; ///< their middles
    WorldBox m_changed;
    WorldBox m_bounds;
    std::uint64_t m_revision = 0;
    Counters m_counters;

    std::size_t m_vertexRoom = 0; ///< the middles of faces follow after this many vertices
    std::size_t m_faceRoom = 0;
    Buffer m_vertices;
    Buffer m_elements;
    std::optional<VertexArray> m_array;
};

} // namespace gpu
