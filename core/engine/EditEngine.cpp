// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EditEngine.h"

#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

Ticket submitWhole(EditEngine& engine, EngineEdit edit, std::vector<EngineExtension> extensions)
{
    engine.submit(BeginEdit{std::move(edit)});
    for (EngineExtension& extension : extensions) {
        ExtendEdit next;
        next.extension = std::move(extension);
        engine.submit(std::move(next));
    }
    return engine.submit(EndEdit{Ending::Commit});
}

Ticket submitWhole(EditEngine& engine, EngineEdit edit)
{
    return submitWhole(engine, std::move(edit), std::vector<EngineExtension>());
}

} // namespace core
