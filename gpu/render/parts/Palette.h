// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Texture2D.h"
#include "gpu/scene/Scene.h"

namespace gpu {

/// Colour of each label and whether it is shown, 256 × 1, RGBA8 (alpha 1: shown). At label 0, the
/// colour that warns (alpha 0).
class Palette {
public:
    Palette();

    void set(const SegmentDisplay& segments);
    [[nodiscard]] const Texture2D& texture() const { return m_texture; }
    [[nodiscard]] bool warns() const { return warnAfterGeneration() != 0xFFFFFFFFu; }
    /// After which generation members warn (SegmentDisplay).
    [[nodiscard]] std::uint32_t warnAfterGeneration() const
    {
        return m_current.warnAfterGeneration;
    }
    [[nodiscard]] bool showsBarriers() const { return m_current.showBarriers; }

private:
    Texture2D m_texture;
    SegmentDisplay m_current;
};

} // namespace gpu
