// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"

#include <optional>

namespace gpu {

/// GPU time between begin() and end(). One may be open at a time in a context.
class TimerQuery {
public:
    TimerQuery() = default;
    explicit TimerQuery(const char* label);

    void begin();
    void end();
    /// None while the GPU has not finished; never waits.
    [[nodiscard]] std::optional<double> milliseconds() const;

private:
    GlId<glDelete::query> m_id;
};

} // namespace gpu
