// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EditEngine.h"

#include <utility>

namespace core {

Ticket submitWhole(EditEngine& engine, EngineEdit edit, std::vector<EngineExtension> extensions)
{
    engine.submit(BeginEdit {std::move(edit)});
    for (EngineExtension& extension : extensions)
        engine.submit(ExtendEdit {std::move(extension)});
    return engine.submit(EndEdit {Ending::Commit});
}

} // namespace core
