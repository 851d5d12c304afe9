// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/cases/RealSegment.h"

#include <cstddef>
#include <memory>

namespace peer {

/// The segment of one real series after another, each opened once for all that is asked of it in a
/// row. With BURIN_LONG=1 of whole series, else of the voxels around their middle.
class OneRealSegment {
public:
    /// @return null: the shared data are not there; or it cannot be opened, which a warning says
    [[nodiscard]] RealSegment* of(core::EditEngine& engine, std::size_t series);
    /// Ends its session, before the engine is gone.
    void close() { m_segment.reset(); }

private:
    std::unique_ptr<RealSegment> m_segment;
    std::size_t m_series = realSeries().size();
};

} // namespace peer
