// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Gl.h"

namespace gpu {

/// Tells when all GL work queued before it is done. Move-only.
class Fence {
public:
    Fence() = default; ///< none: counts as passed
    [[nodiscard]] static Fence insert();
    Fence(Fence&& other) noexcept;
    Fence& operator=(Fence&& other) noexcept;
    ~Fence();

    [[nodiscard]] bool passed() const; ///< never waits
    void wait() const;

private:
    GLsync m_sync = nullptr;
};

} // namespace gpu
