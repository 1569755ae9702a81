import {start} from './main.js'; start(() => { throw new Error('none'); }, '');
