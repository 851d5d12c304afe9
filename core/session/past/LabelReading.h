// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EditEngine.h"
#include "core/session/past/LabelReader.h"

#include <set>

namespace core {

/// Asks the engine for everything that a LabelReader reads, portion by portion. Two questions are
/// on their way at a time: when the engine has answered one, the next is there already, and it does
/// not begin with the work that it does while nothing waits. The session's thread.
class LabelReading {
public:
    LabelReading(const glm::ivec3& size, std::uint8_t plane);

    /// Asks for the next portions; to be called at first, and after each answer.
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
