/** All tables. */

import { FILTRATION } from "./filtration";
import { HALFEDGES } from "./halfedges";
import { COVER, SOLIDS } from "./pages";
import { POLYGON } from "./polygon";
import { SEGMENTS } from "./segments";
import { SPLINES } from "./splines";
import type { Table } from "./table";

export const TABLES: Table[] = [SEGMENTS, SPLINES, SOLIDS, FILTRATION, COVER, HALFEDGES, POLYGON];
