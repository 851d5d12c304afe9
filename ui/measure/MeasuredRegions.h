// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/measure/RegionReader.h"

namespace ui {

class Workspace;

/// Computes the sizes of all measurements of the session, and the values in regions and under
/// probes, one after the other in the background (RegionReader). Results go to the workspace
/// (setMeasured()), where views and panels read them. They stay valid until the session closes,
/// because the volume never changes, and are therefore kept even while a measurement is undone.
class MeasuredRegions : public QObject {
    Q_OBJECT

public:
    explicit MeasuredRegions(Workspace& workspace, QObject* parent = nullptr);

    /// Whether a measurement is being computed.
    [[nodiscard]] bool busy() const { return m_reader.busy(); }

private:
    /// Starts with the first measurement that is not computed yet, unless one is under way.
    void lookOn();
    void take(const core::Measurement& measurement, const RegionReader::Found& found);

    Workspace& m_workspace;
    RegionReader m_reader;
};

} // namespace ui
