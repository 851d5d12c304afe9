// SPDX-License-Identifier: Apache-2.0
#pragma once

// The one place that names the GL loader. Included by gpu/gl headers and gpu sources only.
#include <epoxy/gl.h>
