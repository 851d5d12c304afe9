// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MessageBar;
class Workspace;

/// The message that is shown speaks of the last step, which its button takes back: it is dismissed
/// as soon as another step is made, or that one is undone. Another message that is shown until then
/// stays.
void dismissAtNextStep(MessageBar& bar, Workspace& workspace);

} // namespace ui
