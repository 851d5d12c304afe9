// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/render/parts/ChunkTextures.h"
#include "gpu/render/parts/ColourTable.h"
#include "gpu/render/parts/Palette.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/shaders/RecentPrograms.h"

#include <utility>

namespace gpu {

class VolumeTextures;

/// Draws any plane through the volume: grey values by window/level (DICOM LINEAR), or their
/// colours, fill and outline of segments (where they overlap, those of higher label planes over
/// those of lower ones, and all lines over all fills), the outlines of what is carved away and of
/// each piece that was cut out, at its true place, stripes where growth is barred, a warning colour
/// for members of late generations, hatching over what a cut would remove, and chunks in their
/// colours. A segment is shown as it would be at a tolerance if the scene asks for it and the field
/// is valid. Outside the volume the picture is black. Grey values are interpolated as the scene
/// says, cubic ones linearly while the target is not cubic. They may be those of a slab
/// (SceneSlab).
class SlicePass {
public:
    /// Throws ShaderError. @param library outlives the pass
    explicit SlicePass(const ShaderLibrary& library);

    /// Prepares everything for drawing a full-screen triangle. Cheap; called for every tile, since
    /// other work may run between two tiles.
    /// @param chunks of the scene; null if none are drawn
    void prepare(VolumeTextures& volume, const SliceScene& scene, const SegmentDisplay& segments,
        const Palette& palette, const PassTarget& target, const ChunkTextures* chunks = nullptr);
    /// The same for the cutting plane of the 3D view (planePixel.glsl).
    /// @param look how a slice looks; its position is ignored
    /// @param chunks of the look, in the colours of bodies; null if none are drawn
    /// @return the program; the caller sets where the plane is seen and which segment is refined,
    /// and uses it
    [[nodiscard]] Program& prepareOnPlane(VolumeTextures& volume, const SliceScene& look,
        const SegmentDisplay& segments, const Palette& palette, const PassTarget& target,
        const ChunkTextures* chunks);

private:
    /// Where the plane is drawn, and how its grey values come about: a sum of these bits; 0 is a
    /// slice that is interpolated linearly.
    enum Form : unsigned { Cubic = 1, OnPlane = 2, Slab = 4, Nearest = 8 };

    /// @param where OnPlane, Slab or 0
    [[nodiscard]] Program& prepareForm(unsigned where, VolumeTextures& volume,
        const SliceScene& scene, const SegmentDisplay& segments, const Palette& palette,
        const PassTarget& target, const ChunkTextures* chunks);
    /// @param variant a sum of bits: 1 labels, 2 carved, 4 barriers, 8 members that warn, 16 a
    /// segment at a tolerance, 32 what a cut would remove, 64 chunks, 128 pieces; and 256 for each
    /// label plane that is in use beside plane 0
    [[nodiscard]] Program& programFor(unsigned form, unsigned variant);

    const ShaderLibrary& m_library;
    ColourTable m_colours;
    /// By form and variant, compiled when needed.
    RecentPrograms<std::pair<unsigned, unsigned>, Program, 32> m_programs;
};

} // namespace gpu
