// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/tools/common/OutlineTool.h"

namespace ui {

/// Cuts out what lies under a sketched curve, along the view direction: through everything, down to
/// a depth below the surface, or only through the first layer of material.
class ScissorsTool : public OutlineTool {
    Q_OBJECT

public:
    struct Settings {
        bool limited = false; ///< limited to depthMm
        double depthMm = 20.0;
        bool firstLayerOnly = false;
        bool depthByPressure = false; ///< the pen's pressure sets the depth, if limited
    };
    static constexpr double minimumDepthMm = 0.5;
    static constexpr double maximumDepthMm = 300.0;

    using OutlineTool::OutlineTool;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] QString iconName() const override;
    [[nodiscard]] QString hint() const override;
    [[nodiscard]] QString keys() const override;
    [[nodiscard]] QWidget* createOptions(QWidget* parent) override;
    [[nodiscard]] QJsonObject settingsJson() const override;
    void applySettings(const QJsonObject& settings) override;
    void changeDepth(int steps) override;

    [[nodiscard]] const Settings& settings() const { return m_settings; }
    void setSettings(const Settings& settings);

Q_SIGNALS:
    void changed();

protected:
    void cut(const Sketch& sketch) override;
    [[nodiscard]] bool depthFollowsPressure() const override
    {
        return m_settings.limited && m_settings.depthByPressure;
    }
    [[nodiscard]] QStringList lines() const override;

private:
    /// How deep the curve goes that is being drawn; what is set while there is none.
    [[nodiscard]] double depthMm() const;

    Settings m_settings;
};

} // namespace ui
