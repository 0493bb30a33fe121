// Where the bridge begins.
import { WebSocketServer } from 'ws';

console.log(typeof WebSocketServer);
