#include "fastscene/trace/kernel/things.h"
