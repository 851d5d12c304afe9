// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/ReadLabels.h"

#include "core/session/past/LabelReader.h"

namespace core {

Result<std::vector<std::uint8_t>> readLabels(OperationQueue& queue, std::uint8_t plane, Field field)
{
    LabelReader reader(queue.state().document.volumes.front().geometry.size, plane, field);
    Result<void> taken;
    while (auto question = reader.next()) {
        bool answered = false;
        queue.ask(*std::move(question), [&](const EngineResult& result) {
            answered = true;
            taken = reader.take(result);
        });
        while (!answered) {
            queue.state().engine.finish();
            queue.poll();
        }
        if (!taken)
            return tl::unexpected(taken.error());
    }
    return reader.takeLabels();
}

} // namespace core
