// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"

#include <optional>

namespace gpu {

/// Measures the GPU time between begin() and end(). Only one query may be open at a time in a
/// context.
class TimerQuery {
public:
    TimerQuery() = default;
    explicit TimerQuery(const char* label);

    void begin();
    void end();
    /// The measured time, or none while the GPU has not finished; never waits.
    [[nodiscard]] std::optional<double> milliseconds() const;

private:
    GlId<glDelete::query> m_id;
};

} // namespace gpu
