// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/measure/RegionReader.h"

namespace ui {

class Workspace;

/// Works out what measurements come to, with the values in regions and under probes, one after the
/// other, beside the window (RegionReader). What is found is handed to the workspace (measured()),
/// where views and panels read it. Since the study never changes, it is kept until the session
/// closes, also while undo has taken a measurement back.
class MeasuredRegions : public QObject {
    Q_OBJECT

public:
    explicit MeasuredRegions(Workspace& workspace, QObject* parent = nullptr);

    /// Whether some are still to be worked out.
    [[nodiscard]] bool busy() const { return m_reader.busy(); }

private:
    /// Begins with the first that is not known, unless one is under way.
    void lookOn();
    void take(const core::Measurement& measurement, const RegionReader::Found& found);

    Workspace& m_workspace;
    RegionReader m_reader;
};

} // namespace ui
