// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EditEngine.h"
#include "core/session/past/LabelReader.h"

#include <set>

namespace core {

/// Asks the engine for all that a LabelReader reads. Two portions are on their way at a time, so
/// that the engine finds the next question when it has answered one, and does not begin with what
/// it does between edits. The session's thread.
class LabelReading {
public:
    LabelReading(const glm::ivec3& size, std::uint8_t plane);

    /// Asks on, to be called at first and after each answer.
    /// @return false: everything was read
    [[nodiscard]] bool ask(EditEngine& engine);
    [[nodiscard]] bool awaits(Ticket ticket) const { return m_asked.count(ticket) != 0; }
    /// Keeps an answer that it awaits. Errors: those of the engine.
    [[nodiscard]] Result<void> take(const EngineResult& answer);

    [[nodiscard]] const LabelReader& reader() const { return m_reader; }
    [[nodiscard]] LabelReader& reader() { return m_reader; }

private:
    LabelReader m_reader;
    std::set<Ticket> m_asked;
};

} // namespace core
