// SPDX-License-Identifier: Apache-2.0
#include "core/edits/open/OpenStroke.h"

#include "core/engine/EngineEdit.h"

namespace core {

OpenManner OpenStroke::manner() const
{
    return {};
}

OpenStroke::Told OpenStroke::begin(const EngineEdit&, const Document&, bool)
{
    return {};
}

Result<OpenStroke::Told> OpenStroke::extend(const StrokeExtension&, const Document&)
{
    return Told();
}

OpenStroke::Told OpenStroke::lift()
{
    return {};
}

void OpenStroke::carriedOut(const EngineResult&, bool) { }

} // namespace core
