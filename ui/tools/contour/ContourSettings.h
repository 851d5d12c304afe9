// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace ui {

/// What the user chooses for contours that evolve (ContourTool), kept with a session.
struct ContourSettings {
    /// Bubbles: as Bubble, and a click adds one more to the contour that is open.
    enum class Start { Bubble, Bubbles, Segment, Seeds };

    Start start = Start::Bubble; ///< what the contour begins with
    double bubbleMm = 4.0; ///< radius of all bubbles
    /// The pressure of a pen scales the radius of the bubbles of its contour; false: it has no
    /// effect.
    bool radiusByPressure = false;
    /// Bubbles set the interval to the one suggested for their centres.
    bool valuesOfBubble = true;
    int softness = 25; ///< per cent of half the interval's width, 0 … 100
    int smoothness = 50; ///< 0 … 100; so is edge
    int edge = 0;
    double edgeGradient = 0.0; ///< modality units per mm; 0: not chosen
    int generations = 100; ///< greatest number
    bool operator==(const ContourSettings&) const = default;

    static constexpr double minimumBubbleMm = 0.5;
    static constexpr double maximumBubbleMm = 100.0;
    static constexpr double maximumGradient = 1e6;

    /// Whether a contour begins at the place of a click.
    [[nodiscard]] bool startsFromBubbles() const
    {
        return start == Start::Bubble || start == Start::Bubbles;
    }
    /// Makes bubbles larger by this many steps of the wheel; negative: smaller.
    void changeBubble(int steps);
    [[nodiscard]] QJsonObject json() const;
    /// Takes over the values that are present and within their bounds; the others stay.
    void read(const QJsonObject& json);
};

} // namespace ui
