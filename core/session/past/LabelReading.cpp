// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/LabelReading.h"

#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

namespace {

constexpr std::size_t askedAtOnce = 2;

} // namespace

LabelReading::LabelReading(const glm::ivec3& size, std::uint8_t plane)
    : m_reader(size, plane)
{
}

bool LabelReading::ask(EditEngine& engine)
{
    while (m_asked.size() < askedAtOnce) {
        std::optional<ReadBricks> question = m_reader.next();
        if (!question)
            break;
        m_asked.insert(engine.submit(*std::move(question)));
    }
    return !m_asked.empty();
}

Result<void> LabelReading::take(const EngineResult& answer)
{
    m_asked.erase(answer.ticket);
    return m_reader.take(answer);
}

} // namespace core
