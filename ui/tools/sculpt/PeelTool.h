// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/OutlineTool.h"

namespace ui {

/// Removes a shell from the surface inside a sketched curve (seed A §4.4). When the curve is closed
/// the peel is shown at once. Its depth can then be changed in both directions until it is
/// confirmed: by Enter, by the next curve, or by any other action. cancel() takes it back.
class PeelTool : public OutlineTool {
    Q_OBJECT

public:
    static constexpr double minimumDepthMm = 0.5;
    static constexpr double maximumDepthMm = 60.0;

    explicit PeelTool(Workspace& workspace, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;

    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;

    void cancel() override;
    void putAway() override;
    void changeDepth(int steps) override;

    [[nodiscard]] double depthMm() const { return m_depthMm; }
    void setDepthMm(double depthMm);
    /// Whether a peel waits to be confirmed.
    [[nodiscard]] bool isOpen() const { return m_open; }
    void confirm();

Q_SIGNALS:
    void changed();

protected:
    void cut(const Sketch& sketch) override;
    void begin() override { confirm(); }
    [[nodiscard]] bool showsTaken() const override { return !m_open; }
    [[nodiscard]] SurfacePatch taken(SurfacePatch surface) const override;
    [[nodiscard]] QStringList lines() const override;

private:
    void follow();

    double m_depthMm = 4.0;
    bool m_open = false;
};

} // namespace ui
