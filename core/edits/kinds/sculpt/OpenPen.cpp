// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/sculpt/OpenPen.h"

#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineEdit.h"

#include <utility>

namespace core {

OpenPen::OpenPen(std::vector<PenSample>& samples, MakeSampler makeSampler)
    : m_samples(samples)
    , m_makeSampler(std::move(makeSampler))
{
}

/// Samples of a stroke that had to wait in line are all in the edit by now.
OpenStroke::Told OpenPen::begin(const EngineEdit& command, const Document&, bool)
{
    m_path = m_makeSampler(command);
    Told told;
    if (!m_samples.empty())
        told.push_back(DrillPath{m_path->add(m_samples)});
    return told;
}

Result<OpenStroke::Told> OpenPen::extend(const StrokeExtension& extension, const Document&)
{
    Told told;
    const auto* pen = std::get_if<PenSamples>(&extension);
    if (!pen || pen->samples.empty())
        return told;
    const double last = m_samples.empty() ? 0.0 : m_samples.back().tSeconds;
    const std::vector<PenSample> sound = soundSamples(pen->samples, last);
    if (m_path)
        told.push_back(DrillPath{m_path->add(sound)});
    m_samples.insert(m_samples.end(), sound.begin(), sound.end());
    return told;
}

OpenStroke::Told OpenPen::lift()
{
    Told told;
    if (m_path)
        told.push_back(DrillPath{m_path->finish()});
    return told;
}

} // namespace core
