// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/PieceSet.h"

#include "gpu/fields/textures/VolumeTextures.h"
#include "gpu/render/parts/TransferLookup.h"

#include <glm/gtc/matrix_access.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace gpu {

namespace {

constexpr std::size_t mostPieces = 64; // pieces.glsl, core/edits/document/DocumentEdits.cpp
constexpr int cellSide = MacroCells::side;

/// As in pieces.glsl.
struct GpuPiece {
    std::array<glm::vec4, 3> toTrue;
    std::array<glm::vec4, 3> turn;
    glm::vec4 low;
    glm::vec4 high;
    glm::vec4 atlas;
    glm::vec4 atlasLow;
    glm::vec4 atlasHigh;
    glm::vec4 colour;
    glm::vec4 cellLow;
    glm::vec4 cellHigh;
    glm::vec4 cells;
};
static_assert(sizeof(GpuPiece) == 15 * 16);

glm::dmat4 textureFromWorld(const VolumeTextures& volume)
{
    const glm::dvec3 voxel = 1.0 / glm::dvec3(volume.size());
    glm::dmat4 scale(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        scale[axis][axis] = voxel[axis];
        scale[3][axis] = 0.5 * voxel[axis];
    }
    return scale * volume.geometry().worldToIndex();
}

double zoomOf(const ScenePiece& piece)
{
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(piece.shownFromTrue))));
}

bool isHome(const ScenePiece& piece)
{
    return piece.shownFromTrue == glm::dmat4(1.0);
}

/// At home and looking like the rest: nothing shows that it was cut.
bool isUnseen(const ScenePiece& piece)
{
    return isHome(piece) && piece.layer != 0 && piece.opacity >= 1.0f && piece.rgb == 0xFFFFFF
        && !piece.solid && piece.transferFunction.points.empty();
}

GpuPiece gpuPiece(
    const ScenePiece& piece, const PieceTextures::Entry& entry, const VolumeTextures& volume)
{
    const glm::dvec3 size(volume.size());
    const double zoom = zoomOf(piece);
    const glm::dmat4 toTexture = textureFromWorld(volume);
    const glm::dmat4 toTrue = isHome(piece)
        ? glm::dmat4(1.0)
        : toTexture * glm::inverse(piece.shownFromTrue) * glm::inverse(toTexture);
    const glm::dmat3 turn =
        isHome(piece) ? glm::dmat3(1.0) : glm::dmat3(piece.shownFromTrue) / zoom;
    const glm::dvec3 shift(entry.place - entry.box.minimum);
    const glm::dvec3 room(entry.box.maximum - entry.box.minimum);
    GpuPiece result{};
    for (int i = 0; i < 3; ++i) {
        result.toTrue[std::size_t(i)] = glm::vec4(glm::row(toTrue, i));
        result.turn[std::size_t(i)] = glm::vec4(glm::vec3(turn[i]), 0.0f);
    }
    glm::vec3 low(0.0f);
    glm::vec3 high(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        // Of a cell at the volume's end the outermost half voxel belongs to it.
        if (entry.filled.minimum[axis] > 0)
            low[axis] = float((entry.filled.minimum[axis] + 0.5) / size[axis]);
        if (entry.filled.maximum[axis] < volume.size()[axis])
            high[axis] = float((entry.filled.maximum[axis] + 0.5) / size[axis]);
    }
    result.low = glm::vec4(low, piece.opacity);
    result.high = glm::vec4(high, float(1.0 / zoom));
    result.atlas = glm::vec4(glm::vec3(shift), piece.softness);
    result.atlasLow =
        glm::vec4(glm::vec3(glm::dvec3(entry.place) + 0.5), piece.solid ? 1.0f : 0.0f);
    result.atlasHigh = glm::vec4(glm::vec3(glm::dvec3(entry.place) + room - 0.5), -1.0f);
    result.colour = glm::vec4(float(piece.rgb >> 16 & 255u), float(piece.rgb >> 8 & 255u),
                        float(piece.rgb & 255u), 255.0f)
        / 255.0f;
    result.cellLow = glm::vec4(glm::vec3(entry.box.minimum / cellSide), 0.0f);
    result.cellHigh = glm::vec4(glm::vec3((entry.box.maximum - 1) / cellSide), 0.0f);
    result.cells =
        glm::vec4(glm::vec3(entry.place / cellSide - entry.box.minimum / cellSide), 0.0f);
    return result;
}

} // namespace

PieceSet::PieceSet()
    : m_buffer({.label = "pieces", .bytes = mostPieces * sizeof(GpuPiece)})
    , m_transfers({.label = "transfer functions of pieces",
          .size = {TransferLookup::entryCount, 1},
          .format = GL_RGBA32F})
{
}

double PieceSet::finestZoom(const VolumeScene& scene)
{
    double zoom = 1.0;
    for (const ScenePiece& piece : scene.pieces)
        zoom = std::min(zoom, zoomOf(piece));
    return std::max(zoom, 0.25);
}

bool PieceSet::set(VolumeTextures& volume, const VolumeScene& scene, double stepMm)
{
    std::vector<const ScenePiece*> seen;
    for (const ScenePiece& piece : scene.pieces) {
        const PieceTextures::Entry* entry = volume.pieces().entry({piece.layer, piece.segment});
        const bool shows = entry && !entry->filled.empty() && piece.showsIn(scene.mode);
        if (shows && seen.size() < mostPieces)
            seen.push_back(&piece);
    }
    m_count = int(seen.size());
    m_home = 0;
    if (seen.empty())
        return false;
    // In an order of their own, so that the list's decides nothing.
    std::sort(seen.begin(), seen.end(), [](const ScenePiece* a, const ScenePiece* b) {
        return isUnseen(*a) != isUnseen(*b) ? isUnseen(*a)
                                            : std::tie(a->id, a->layer) < std::tie(b->id, b->layer);
    });
    std::vector<GpuPiece> pieces;
    std::vector<const ScenePiece*> rows;
    for (const ScenePiece* piece : seen) {
        m_home += isUnseen(*piece) ? 1 : 0;
        pieces.push_back(
            gpuPiece(*piece, *volume.pieces().entry({piece->layer, piece->segment}), volume));
        if (scene.mode != RenderMode::Dvr || piece->transferFunction.points.empty())
            continue;
        const glm::dvec2 entry =
            TransferLookup::entryOfTexel(piece->transferFunction, volume.encoding());
        pieces.back().atlasHigh.w = float(rows.size());
        pieces.back().cellLow.w = float(entry.x);
        pieces.back().cellHigh.w = float(entry.y);
        rows.push_back(piece);
    }
    m_buffer.write(std::span<const GpuPiece>(pieces));
    setTransfers(rows, stepMm);
    return true;
}

void PieceSet::setTransfers(const std::vector<const ScenePiece*>& rows, double stepMm)
{
    std::vector<TransferFunction> functions;
    for (const ScenePiece* piece : rows)
        functions.push_back(piece->transferFunction);
    if (functions == m_rows && stepMm == m_stepMm)
        return;
    m_rows = std::move(functions);
    m_stepMm = stepMm;
    if (m_rows.empty())
        return;
    std::vector<float> texels;
    for (const TransferFunction& function : m_rows) {
        const std::vector<float> row = TransferLookup::texelsOf(function, stepMm);
        texels.insert(texels.end(), row.begin(), row.end());
    }
    m_transfers = Texture2D({.label = "transfer functions of pieces",
        .size = {TransferLookup::entryCount, int(m_rows.size())},
        .format = GL_RGBA32F});
    m_transfers.upload<float>(texels);
}

void PieceSet::bind(Program& program, VolumeTextures& volume) const
{
    m_buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    volume.pieces().footprints().bindUnit(9);
    volume.pieces().cells().bindUnit(10);
    m_transfers.bindUnit(11);
    program.set("pieceCount", m_count).set("homeCount", m_home);
}

} // namespace gpu
