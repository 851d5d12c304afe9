// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/ColourMap.h"

namespace gpu {

/// The colours of grey values as a texture of 256 × 1 texels, RGBA8 (render/parts/colourMap.glsl).
class ColourTable {
public:
    ColourTable();

    /// Binds the texture and has a program show a map. Grey costs no look-up, and changes no pixel.
    void bind(Program& program, ColourMap map);

private:
    Texture2D m_texture;
    ColourMap m_current = ColourMap::Grey; ///< which the texture holds; of Grey it need not
};

} // namespace gpu
