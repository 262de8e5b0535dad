#include "fastscene/trace/kernel/cloth.h"
